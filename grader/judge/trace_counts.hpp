#pragma once

#include <string_view>

#include "judge/gl_calls.hpp"

namespace umbral::grader {

/// What a call adds to a rule of trace_rules; 0 if the rule does not look at it. "deprecated calls" and "state changes" count calls,
/// "vertices" what they draw, "objects ..." by the counts that glGen..., glCreate... and glDelete... are given.
[[nodiscard]] double share_of(const GlCall& call, std::string_view rule);

[[nodiscard]] double counted(const GlTrace& trace, std::string_view rule);

/// Must the student's count equal the reference's? Otherwise it must not exceed it.
[[nodiscard]] bool must_equal(std::string_view rule);

}
