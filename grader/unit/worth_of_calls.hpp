#pragma once

#include "model/scorecard.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Calls are worth what they draw: a check of how something is drawn (JudgeRecord::is_of_drawing) earns no larger share
/// than the picture has of the right one, the one of its case that has most, or of the unit if its case has none. One
/// that has half of it, or only its outlines in other colours, is enough for all points; calls that are few and draw
/// nothing, or anything else, earn none. Where the unit checks no picture, calls keep what they earned.
void weigh_calls(Worker& worker, const Exercise& exercise, const CaseResults& cases, UnitResult& result);

}
