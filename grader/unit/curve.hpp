#pragma once

#include <optional>

#include "model/curve.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Where the student's choice lies on the curve of the unit's knob, from the runs that were graded; nothing where the
/// unit has no knob, where a run did not end well, or where under half of the unit's points were earned: what is wrong
/// is no choice of accuracy.
///
/// The other points are those of the reference, of the oracle where the check is judged against it, and of the
/// unit's solutions that say they are settings of it, on the same inputs. Both cases are visible, so their runs are
/// kept, and made once on a machine. Throws std::runtime_error for a fault of the grader's.
[[nodiscard]] std::optional<UnitCurve> curve_of(Worker& worker, const Exercise& exercise, const UnitResult& result,
                                                const CaseResults& cases);

/// The 95th percentile of the errors of a judgement's rows, in the unit of the check's tolerance, over those that have
/// one; nothing where more than half of the rows have none.
[[nodiscard]] std::optional<double> error_on_curve(const std::map<std::string, double>& metrics);

}
