#pragma once

#include <array>
#include <string_view>

namespace umbral::grader {

/// The fields of a check in exercise.json that do not belong to one judge alone (JudgeRecord::own_fields).
inline constexpr std::array<std::string_view, 15> check_fields{"case",   "value",    "judge",     "points", "hard",
                                                               "hidden", "pairs",    "tolerance", "full",   "zero",
                                                               "range",  "relation", "why",       "rubric", "with"};

}
