#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "build/builder.hpp"
#include "build/submission.hpp"
#include "model/exercise.hpp"
#include "model/verdict.hpp"

namespace umbral::grader {

/// A solution that comes with a unit: a known mistake, or another right way to write it.
struct KnownSolution {
    std::string name;           ///< the file's name without suffix
    std::string what;           ///< what is wrong, or how it differs
    std::string hint;           ///< a mistake's, for the student
    double least_credit = 100;  ///< percent of the unit's points
    double most_credit = 100;
    std::optional<Verdict> verdict;          ///< expected one, if not decided by the credit
    std::optional<std::size_t> rubric_line;  ///< of the unit's rubric, from 0 on: it breaks this one and no other
    std::filesystem::path file;
    Sources sources;  ///< the whole unit: this file, the rest from the reference
};

/// Where the reference's own files are expected below the folder `reference`, by the names that students use.
[[nodiscard]] std::map<std::string, std::filesystem::path> reference_files(const std::filesystem::path& reference,
                                                                           const Exercise& exercise);

/// The reference's own files, under the names that students use.
[[nodiscard]] Sources reference_sources(const std::filesystem::path& reference, const Exercise& exercise);
/// The files of the stub.
[[nodiscard]] Sources stub_sources(const Exercise& exercise);

/// The unit's mistakes/ and alternatives/, sorted by name. Throws std::runtime_error with file and line if a header is
/// malformed.
[[nodiscard]] std::vector<KnownSolution> mistakes_of(const std::filesystem::path& reference, const Exercise& exercise);
[[nodiscard]] std::vector<KnownSolution> alternatives_of(const std::filesystem::path& reference,
                                                         const Exercise& exercise);

/// A mistake as if it had been handed in: what runs is the library that comes with the unit.
[[nodiscard]] Built as_built(const KnownSolution& mistake);

}
