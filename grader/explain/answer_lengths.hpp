#pragma once

#include <string>

#include "explain/asked_answers.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {

/// Of a check's questions: which lists in the answers have another number of elements than the right ones, and how
/// many: "polygon_segments: the answer has half as many elements as it should in 9 of 9 calls". Counted is what the
/// calls themselves return or write, whatever the driver records of it. Empty where all are right; its runs take from
/// `time`.
[[nodiscard]] std::string answer_lengths(Worker& worker, const AskedCheck& asked, SpareTime& time);

}
