#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "judge/trace/gl_calls.hpp"

namespace umbral::grader {

/// What a trace of OpenGL calls can be held to.
inline constexpr std::array<std::string_view, 7> trace_rules{"draw calls",      "vertices",        "uploaded bytes",
                                                             "objects created", "objects deleted", "deprecated calls",
                                                             "state changes"};

/// What only this judge takes.
struct TraceParameters {
    std::vector<std::string> rules;  ///< what is counted against the reference, some of trace_rules
};

/// What a call adds to a rule of trace_rules; 0 if the rule does not look at it. "deprecated calls" and "state changes"
/// count calls, "vertices" what they draw, "objects ..." by the counts that glGen..., glCreate... and glDelete... are
/// given.
[[nodiscard]] double share_of(const GlCall& call, std::string_view rule);

[[nodiscard]] double counted(const GlTrace& trace, std::string_view rule);

/// Does the student's count keep a rule? Vertices and objects must be as many as the reference's, other counts no more.
/// Uploaded bytes must be a third of them at least: tables may be stored in smaller types, but not stay where they are.
[[nodiscard]] bool keeps(std::string_view rule, double yours, double expected);

}
