#pragma once

#include "model/scorecard.hpp"
#include "unit/grade_unit.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Writes the questions behind first wrong values in full, where reports show them shortened (meshes, files, textures),
/// beside the pictures: as code that `umbral ask UNIT --file` reads. Of visible checks only; at most three files, each
/// of at most a mebibyte. Their names are made of the unit's and the check's, and stand among the checks' artefacts as
/// "question".
void save_long_questions(Worker& worker, const Exercise& exercise, const CaseResults& cases,
                         const GradeOptions& options, UnitResult& result);

}
