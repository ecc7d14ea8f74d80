#pragma once

#include <sys/types.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "run/descriptor.hpp"
#include "run/sandbox.hpp"

namespace umbral::grader {

/// What a confined program may know to exist. Landlock decides what it can open; but asking whether a file is there
/// (stat, access, an open that fails) is no right that Landlock knows, and a compiler asks on behalf of what it
/// compiles: `__has_include`, `.incbin`, the wording of an error. The gate answers "no such file" for everything
/// outside its rules, whatever is there.
///
/// A rule is a tree ("/usr/include"), a file, or the files of one folder but not its folders
/// ("/usr/lib/x86_64-linux-gnu/*").
class PathRules {
public:
    PathRules(std::filesystem::path directory, std::span<const std::string> rules);

    /// May `path` be asked for? A relative one counts from the working directory. `..` is taken out before, as
    /// the kernel does it; other links are followed by the kernel, within what Landlock allows. The folders above a
    /// rule's are known to exist.
    [[nodiscard]] bool admits(std::string_view path) const;

private:
    std::filesystem::path directory_;
    std::vector<std::string> trees_;
    std::vector<std::string> folders_;
};

/// Answers the calls that sandbox::compiler_filter(true) holds back, for the process `child` and all that it starts,
/// until it ends. `listener` is what installing the filter gave. The program is trusted, and only what it reads is not:
/// so a path may be read and then the call let go. Whoever asks far more often than compiling takes gets no more
/// answers: then every path is refused alike.
void guard_paths(Descriptor listener, pid_t child, const PathRules& rules);

}
