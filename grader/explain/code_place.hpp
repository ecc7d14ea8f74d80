#pragma once

#include "build/submission.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Sets `code_place` of the first failing check of which it is known, as students are shown them: the line of the
/// student's own file that questions with wrong answers come through, and those with right ones do not, or the reverse.
/// Where nearly all answers of a check are wrong, those of other visible cases to the same function are looked at too.
/// It holds on inputs of other seeds as well. The files are built once more for it, and run again; nothing where a
/// reason that explains all is very likely, or where they answer something else when built so.
void add_code_place(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                    UnitResult& result);

}
