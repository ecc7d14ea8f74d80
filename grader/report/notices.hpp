#pragma once

#include <string>
#include <vector>

#include "model/faults.hpp"
#include "model/scorecard.hpp"

namespace umbral::grader {

/// Something that whoever reads a class's results must know before the results. Texts are sentences; those from outside
/// are not escaped yet.
struct Notice {
    bool fault = false;    ///< points are missing, or reports; otherwise only to be known
    std::string headline;  ///< what it means: "2 units of 1 submission are not scored: 20 points are in no sum."
    std::string cause;     ///< what happened; may be empty
    std::string remedy;    ///< what to do
    std::vector<Fault::Place> who;  ///< unit empty: all of the submission
};

/// What stands at the head of a class's table and page: faults by cause, what is unfinished, what is not graded,
/// and what was graded elsewhere.
[[nodiscard]] std::vector<Notice> notices(const ClassResult& result);

/// "ana: raytracing/sphere, lighting/shaders; bruno: raytracing/sphere and 20 more": who is concerned, in at most
/// caps::listed submissions.
[[nodiscard]] std::string who_in_words(const Notice& notice);

}
