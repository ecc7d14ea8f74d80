#pragma once

#include <span>
#include <string>

#include "cli/application.hpp"

namespace umbral::grader {

// In an installation all is built but the precompiled header of students' files, which fits one compiler only and lies
// in the user's cache. In a checkout only what somebody asked for is built: the program by the launcher, units and
// further programs by the commands that need them. A line on the standard error stream says what is being built. Both
// throw std::runtime_error, with the compiler's first errors, if it cannot be.

/// What is needed of a unit: its answers and driver, or also its known mistakes.
enum class UnitParts { answers, all };

/// Were all parts of these units built, of the sources as they are? In an installation they were.
[[nodiscard]] bool are_built(const Application& application, std::span<const Exercise> units);

/// Builds those of the units whose parts were not built yet, or whose sources were changed since; in an
/// installation the precompiled header, if this compiler has none yet.
void have_built(const Application& application, std::span<const Exercise> units, UnitParts parts = UnitParts::all);

/// Builds the program `name` if it was not built yet. Its path. Throws UsageError in an installation that does not hold
/// it.
[[nodiscard]] std::filesystem::path have_program(const Application& application, const std::string& name);

/// The path of umbral-mutate, built if it was not yet. Throws UsageError in an installation, which holds none, with
/// `purpose` before the reason: "validate --mutants finds mutants". Where libclang is missing, too.
[[nodiscard]] std::filesystem::path have_finder(const Application& application, std::string_view purpose);

/// Was libclang there when the build was configured last, so that have_finder() may find the program?
[[nodiscard]] bool may_have_finder(const Application& application);

/// In a checkout: builds the program `name` anew if its sources changed, so that what is measured is what they say.
/// Those `of_tests` have targets only if the build was configured with the tests: if it was not, it is now. Throws
/// UsageError, and leaves the build as it was, if that is not possible. The program's path.
[[nodiscard]] std::filesystem::path have_fresh_program(const Application& application, const std::string& name,
                                                       bool of_tests);

}
