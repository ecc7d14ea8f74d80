#pragma once

#include <vector>

#include "collect/class_folder.hpp"
#include "collect/handed.hpp"
#include "model/exercise.hpp"
#include "model/scorecard.hpp"

namespace umbral::grader {

/// What a class handed in, which tells what its task was.
struct HandedIn {
    std::vector<Exercise> task;      ///< units that enough submissions have files of, in the order given
    std::vector<LeftOut> too_few{};  ///< units that others have files of
};

/// How many of so many submissions must have files of a unit for it to be the class's task: a tenth, and two if there
/// are two. Nobody alone makes a unit part of everybody's sum.
[[nodiscard]] std::size_t submissions_for_a_task(std::size_t submissions) noexcept;

/// Looks through the submissions. Files that are still the stub are not handed in, and who handed in nothing does not
/// count.
[[nodiscard]] HandedIn handed_in(const std::vector<SubmissionFolder>& submissions,
                                 const std::vector<Exercise>& exercises, const ArchiveTools& archives);

}
