#include "build/with_zeros.hpp"

#include <algorithm>

namespace umbral::grader {

std::optional<Built> build_with_zeros(const Toolchain& tools, const Exercise& exercise, const Built& built)
{
    Toolchain changed = tools;
    const auto filled = std::ranges::find(changed.flags, "-ftrivial-auto-var-init=pattern");
    if (filled == changed.flags.end() || !exercise.is_cpp()) return std::nullopt;
    *filled = "-ftrivial-auto-var-init=zero";
    for (const char* const flag : {"-Wuninitialized", "-Wmaybe-uninitialized"}) changed.flags.emplace_back(flag);
    changed.budget = built.budget;
    Built zeros = build(changed, exercise, built.files);
    zeros.fresh_memory = FreshMemory::lasting_zeros;
    return zeros;
}

}
