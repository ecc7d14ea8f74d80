#pragma once

#include <optional>

#include "build/builder.hpp"

namespace umbral::grader {

/// Builds the files of `built` once more, within its budget, so that variables which were never given a value hold
/// zeros, where `build` has them hold what cannot be right (UMBRAL_STUDENT_FLAGS), and memory from `new` too when it
/// runs. Its message holds the compiler's warnings of such variables. Nothing for a unit without C++, or if the
/// compiler cannot fill them.
[[nodiscard]] std::optional<Built> build_with_zeros(const Toolchain& tools, const Exercise& exercise,
                                                    const Built& built);

}
