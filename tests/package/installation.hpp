#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/printed.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::test {

inline std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && !entry.is_symlink()) files.push_back(entry.path());
    return files;
}

/// What `cmake --install` makes below a fresh prefix: both components, or one.
class Installation {
public:
    explicit Installation(const std::string& component = "")
    {
        const Printed printed = run(UMBRAL_CMAKE " --install " UMBRAL_BUILD " --prefix " + prefix().string() +
                                    (component.empty() ? "" : " --component " + component));
        if (printed.status != 0) throw std::runtime_error("cmake --install failed: " + printed.text);
    }
    [[nodiscard]] std::filesystem::path prefix() const { return folder_ / "prefix"; }

private:
    TemporaryFolder folder_;
};

/// With everything.
inline const Installation& everything()
{
    static const Installation one;
    return one;
}

/// What students get.
inline const Installation& students()
{
    static const Installation one("umbral");
    return one;
}

/// May this user mount something in a namespace of their own?
inline bool has_namespaces()
{
    static const bool has = run("unshare -r -m true").status == 0;
    return has;
}

/// Words before a command that make it run where neither sources nor build are, if the machine allows it.
inline std::string without_sources()
{
    if (!has_namespaces()) return "";
    return "cd / && exec unshare -r -m sh -c 'mount -t tmpfs none " UMBRAL_BUILD
           " && mount -t tmpfs none " UMBRAL_SOURCE " && exec \"$@\"' sh ";
}

/// The same namespace with all in its place, for what is compared with it.
inline std::string with_sources() { return has_namespaces() ? "cd / && exec unshare -r -m " : "cd / && exec "; }

}
