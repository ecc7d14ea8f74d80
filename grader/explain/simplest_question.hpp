#pragma once

#include "build/submission.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Looks for a wrong value with a question that can be worked out by hand: on inputs drawn from random numbers of few
/// bits (Grain), by the driver's own generators, so that they keep what the unit promises of its inputs. Sets
/// `simplest` of the visible checks that are shown first, where the question is much shorter than that of their first
/// wrong value.
void add_simplest_question(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                           UnitResult& result);

}
