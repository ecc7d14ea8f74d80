#pragma once

#include "judge/evidence/evidence.hpp"
#include "judge/rows/alignment.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

// How evidence that several judges give is made; all tensors are well formed. None throws for what a student recorded.

/// Of pictures and buffers. `right`: only the picture itself is of interest.
[[nodiscard]] Evidence picture_evidence(const Check& check, const Observation& observation, bool right);

/// Of rows of numbers and of matrices. Nothing if they are right.
[[nodiscard]] Evidence rows_evidence(const Check& check, const Observation& observation, bool right);

/// Lines of both sides with what belongs together.
struct Sides {
    std::vector<std::string> yours;
    std::vector<std::string> expected;
    Alignment alignment;
    std::size_t first_number = 1;  ///< lines of texts are counted from 1, rows of tables from 0
};
inline constexpr std::size_t most_compared_lines = 4000;  ///< of each side

/// Two lists beside each other; `cut`: there were more lines than were compared.
[[nodiscard]] LinesEvidence lines_evidence(const Sides& sides, std::string what, bool cut);

}
