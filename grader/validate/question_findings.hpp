#pragma once

#include <vector>

#include "validate/validate.hpp"
#include "worker/seeds.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Every row that is compared must have its question: a value without one tells a student nothing but itself. A finding
/// for each case where one has none, or where the reference does not end well when it is asked for questions.
[[nodiscard]] std::vector<Finding> expect_questions(Worker& worker, const Exercise& exercise, const SeedPlan& seeds,
                                                    unsigned seed);

}
