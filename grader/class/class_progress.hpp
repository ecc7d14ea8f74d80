#pragma once

#include <cstddef>
#include <string>

namespace umbral::grader {

/// How far a class is.
struct ClassProgress {
    std::string finished{};            ///< the submission that is done now; empty if only a unit is
    bool again = false;                ///< units with faults are graded once more now, alone
    std::size_t submissions_done = 0;  ///< with those of which everything was kept
    std::size_t submissions = 0;
    std::size_t units_graded = 0;
    std::size_t units_to_grade = 0;  ///< in this run, those graded among them
    double seconds = 0;              ///< since grading began
};

/// "12/200 submissions, 3.1 units/s, about 4 min left". Rate and time are left out while there is too little to tell
/// them from.
[[nodiscard]] std::string progress_text(const ClassProgress& progress);

}
