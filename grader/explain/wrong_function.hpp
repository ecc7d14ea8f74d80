#pragma once

#include <string>

#include "explain/asked_answers.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {

/// Of a check whose answers come of several functions, if those of only one of them are wrong: "only answers of
/// rotation_about_z are wrong (6 of 6), none of rotation_about_x and rotation_about_y (12)". Else empty; its runs take
/// from `time`.
[[nodiscard]] std::string wrong_function(Worker& worker, const AskedCheck& asked, SpareTime& time);

}
