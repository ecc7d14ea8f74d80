#pragma once

#include <string_view>

#include "model/scorecard.hpp"

namespace umbral::grader {

/// What became of a check, in a word or two: what was not judged is not called wrong.
[[nodiscard]] inline std::string_view check_words(const CheckResult& check)
{
    if (check.score >= check.max_score) return "right";
    if (check.unjudged != Unjudged::no) return in_words(check.unjudged);
    if (check.held_back) return "right by itself";
    return check.score > 0 ? "partly right" : "wrong";
}

}
