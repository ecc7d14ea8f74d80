#pragma once

#include <optional>

#include "build/builder.hpp"

namespace umbral::grader {

/// Builds the files of `built` once more, within its budget, so that its runs can tell through which of their lines
/// each question went (umbral/record/block_trace.hpp): counted, and optimised as for debuggers, which keeps branches
/// apart and can use the precompiled header. Nothing for a unit without C++, or if the files cannot be built so.
[[nodiscard]] std::optional<Built> build_traced(const Toolchain& tools, const Exercise& exercise, const Built& built);

}
