#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "build/submission.hpp"
#include "build/toolchain.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

struct Compilation {
    /// Why there is no library, if there is none.
    enum class Outcome {
        built,
        refused_by_compiler,  ///< with a diagnostic in one of the student's own files, or for its size: so would any
                              ///< other machine
        not_allowed,          ///< holds assembler or the like
        too_expensive,        ///< ran out of processor time or disk: a faster machine may think otherwise
        unexplained           ///< failed without a diagnostic in the student's files: the machine may be in trouble
    };
    Outcome outcome = Outcome::unexplained;
    std::optional<std::filesystem::path> library;  ///< if built
    std::string diagnostics;  ///< for the student: the first errors, or if built warnings, with the student's own file
                              ///< names
    bool lacks_machine = false;  ///< the tools say so of themselves: no processes, no room …
};

/// What becomes of functions that nothing of the unit calls: they stay in the library, as two definitions of one name
/// that the linker must see, or are left out, so that they are not held against the file that they stand in.
enum class UnusedCode { kept, left_out };

/// How the compiler writes down what it says. As JSON, whatever the files put into a message, line feeds too, stays
/// within a text: a line that begins with a tool's name is the tool's own.
enum class Diagnostics { plain, json };

/// Writes `files` into the empty folder `work` and makes `work/student.so` of its .cpp files, in confinement: the
/// compiler sees the folder, what it needs of the system, and the framework's headers. Exported are exactly the names
/// in the unit's exports.map. Throws std::runtime_error if the files cannot be written or the compiler cannot be run.
[[nodiscard]] Compilation compile(const Toolchain& tools, const Exercise& exercise, const Sources& files,
                                  const std::filesystem::path& work, UnusedCode unused = UnusedCode::kept,
                                  Diagnostics diagnostics = Diagnostics::plain);

/// Makes `work/driver.so` of the files as `compile` makes a student's library: in the same confinement, with the same
/// flags. It may export anything, and finds the unit's functions where it is loaded. Throws as `compile` does.
[[nodiscard]] Compilation compile_driver(const Toolchain& tools, const Exercise& exercise, const Sources& files,
                                         const std::filesystem::path& work);

}
