#pragma once

#include <string>

#include "explain/asked_answers.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {

/// Of a check whose rows are compared in any order or by their keys: what the rows have in common that came of no call
/// though they were expected, or that came and were not: "a row is lacking wherever edge.a is 0 (6 of 6), and there
/// everywhere else (30 of 30)". Told is what holds with fresh inputs too. Empty if nothing does; its runs take from
/// `time`.
[[nodiscard]] std::string rows_alone(Worker& worker, const AskedCheck& asked, SpareTime& time);

}
