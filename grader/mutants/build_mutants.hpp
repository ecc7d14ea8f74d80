#pragma once

#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "build/toolchain.hpp"
#include "model/exercise.hpp"
#include "mutants/mutant.hpp"

namespace umbral::grader {

/// A source's mutants, compiled into one library.
struct BuiltMutants {
    std::vector<Mutant> mutants;
    std::size_t not_compiled = 0;  ///< found, but of types that do not fit, or in what the compiler computes
    std::filesystem::path library;
};

/// A source of which no mutants can be built: it is too long, say, or nested too deep, for what reads it.
struct NotMutable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Finds the mutants of this family of `source`, a unit's only C++ file, by the program `finder` (umbral-mutate) and
/// compiles it with all that compile into the folder `work`, in at most so many seconds. Both run confined, so that the
/// source may be anybody's. Throws NotMutable with the compiler's words if it cannot be done.
[[nodiscard]] BuiltMutants build_mutants(const Toolchain& tools, const Exercise& exercise, MutantFamily family,
                                         const std::filesystem::path& finder, const std::string& source,
                                         const std::filesystem::path& work,
                                         double seconds = std::numeric_limits<double>::infinity());

}
