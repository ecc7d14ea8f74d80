#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/scorecard.hpp"

namespace umbral::grader {

/// What stands before the cause in the message of a unit with verdict grader_fault.
inline constexpr std::string_view fault_preface = "the grader failed, not your work; this unit does not count: ";

/// One cause of faults of the grader's, and whom it concerns.
struct Fault {
    struct Place {
        std::string submission;
        std::string unit;  ///< empty: the submission's reports
    };
    std::string cause;       ///< in the words of the first unit that it hit
    std::string remedy;      ///< what to do, as a sentence without its capital and full stop
    Millipoints points = 0;  ///< that are in no sum because of it
    std::vector<Place> places;
};

/// Does a unit of it lack its points to a fault of the grader's?
[[nodiscard]] bool has_fault(const SubmissionResult& submission);

/// The faults of a class, each cause once, in the order in which they first appear. Messages that the system gives for
/// the same trouble (a full disk, say) are one cause, whatever file they name.
[[nodiscard]] std::vector<Fault> faults(const ClassResult& result);

}
