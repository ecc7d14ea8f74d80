#pragma once

#include "model/scorecard.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// A check that hangs on another one (Check::with) earns no larger share than that one. A check of how something is
/// drawn (JudgeRecord::is_of_drawing) hangs on a picture without being told: the best one of its case, or of the unit
/// if its case has none; where the unit checks no picture, on nothing. Of a picture counts what is drawn of the right
/// one: half of it, or its outlines in other colours, is enough for all points, and calls
/// that are as few as they should be, but draw nothing or anything else, keep half of their points.
void weigh_with_others(Worker& worker, const Exercise& exercise, const CaseResults& cases, UnitResult& result);

}
