#pragma once

#include <string>

#include "validate/validate.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {

/// What is wrong with a check of rows that excuses wrong numbers: which of a row's numbers can be 0, or have the other
/// sign, in every row without one row being wrong. That is so where a tolerance is larger than a number ever is: an
/// absolute one, or one relative to the largest number of a row that holds a length of 1e6 beside an angle.
///
/// Looked at are numbers that say something: those of columns whose largest is above a millionth of the table's largest
/// (what lies below is the rounding of a 0), and in them the values above a tenth of the column's largest. "" where
/// each such column counts, where rows are not judged one by one, and for a table of one column, which controls look
/// at.
[[nodiscard]] std::string column_complaint(const Check& check, const Expected& expected);

/// A finding for each check of the unit that has such a complaint.
[[nodiscard]] std::vector<Finding> expect_columns(Worker& worker, const Exercise& exercise, const SeedPlan& seeds,
                                                  unsigned seed);

}
