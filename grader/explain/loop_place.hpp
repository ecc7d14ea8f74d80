#pragma once

#include <string>

#include "build/submission.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Where a visible case that took too long goes round: "from the surface: one call runs lines 6 to 9 of sphere.cpp
/// again and again", as a line; empty where no case did, or that cannot be told. The files are built once more for it,
/// and run until one call has gone through so many blocks (umbral/record/block_trace.hpp) that the clock has no say in
/// what is told.
[[nodiscard]] std::string loop_place(Worker& worker, const Exercise& exercise, const Built& built,
                                     const CaseResults& cases);

}
