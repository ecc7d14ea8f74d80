#include "cli/layout.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <string>

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

Layout in_checkout(const fs::path& build, const fs::path& source)
{
    if (!fs::is_directory(source / "exercises"))
        throw std::runtime_error(fmt::format(
            "{}: expected the folder of the sources that this was built from, got {}, which has no folder exercises; "
            "if it was moved, configure the build again",
            (build / "checkout.txt").string(), source.string()));
    return {.installed = false,
            .build = build,
            .data = source,
            .samples = source / "tests" / "class",
            .attacks = source / "tests" / "attacks",
            .includes = build / "student" / "umbral_student.hpp"};
}

}

Layout layout_around(const fs::path& program)
{
    const fs::path build = program.parent_path().parent_path();
    if (std::ifstream note(build / "checkout.txt"); note) {
        std::string source;
        std::getline(note, source);
        return in_checkout(build, source);
    }
    const fs::path data = build.parent_path().parent_path() / "share" / "umbral";
    if (!fs::is_directory(data / "exercises"))
        throw std::runtime_error(
            fmt::format("{}: expected the units of this installation in {}, where nothing is; install the package "
                        "again, or copy all of it",
                        program.string(), (data / "exercises").string()));
    return {.installed = true,
            .build = build,
            .data = data,
            .samples = data / "class",
            .attacks = data / "attacks",
            .includes = data / "student" / "umbral_student.hpp"};
}

Layout own_layout() { return layout_around(fs::canonical("/proc/self/exe")); }

}
