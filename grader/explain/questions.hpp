#pragma once

#include "build/submission.hpp"
#include "model/scorecard.hpp"
#include "report/html/evidence.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Adds to a graded unit's failing checks what was asked where the first value differs, what the questions with wrong
/// answers have in common, and to `detail`, if there is one, the questions behind the rows that it shows. All of it
/// follows from runs of the reference: nothing that the student's run said is asked.
void add_questions(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                   UnitResult& result, html::UnitDetail* detail);

}
