#include "build/traced.hpp"

#include <algorithm>

namespace umbral::grader {

std::optional<Built> build_traced(const Toolchain& tools, const Exercise& exercise, const Built& built)
{
    if (!exercise.is_cpp() || built.files.empty()) return std::nullopt;
    Toolchain changed = tools;
    std::ranges::replace_if(
        changed.flags, [](const std::string& flag) { return flag.starts_with("-O"); }, std::string("-Og"));
    // A function of the student's own keeps its lines apart from those that call it.
    for (const char* const flag :
         {"-fno-early-inlining", "-fno-inline-small-functions", "-fno-inline-functions-called-once"})
        changed.flags.emplace_back(flag);
    changed.budget = built.budget;
    Exercise counted = exercise;
    counted.counts_work = true;
    Built traced = build(changed, counted, built.files);
    if (traced.verdict != Verdict::ok) return std::nullopt;
    return traced;
}

}
