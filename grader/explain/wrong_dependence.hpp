#pragma once

#include <string>

#include "explain/asked_answers.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {

/// "in entry (row 1, column 3) your wrong answers change with box.left, and the right ones with box.top instead": what
/// wrong answers of a check depend on and should not, or the reverse, found by asking the student's code and the
/// reference again, with each argument of the function moved a little. Of a hidden case with practice inputs only.
/// Empty if nothing is to be told, or if it takes too long. Its runs take from `time`.
[[nodiscard]] std::string wrong_dependence(Worker& worker, const AskedCheck& asked, SpareTime& time);

}
