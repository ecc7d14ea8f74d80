#include "question/answer_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace umbral::grader {
namespace {

constexpr std::size_t least_calls = 3;  ///< of which a difference or a quotient is told

std::string elements(double count) { return fmt::format("{:.0f} element{}", count, count == 1 ? "" : "s"); }

/// "half as many", "3 times as many"; nothing for other quotients.
std::string times_as_many(double quotient)
{
    if (quotient == 0.5) return "half as many";
    if (quotient == 2) return "twice as many";
    const double inverse = 1 / quotient;
    if (quotient > 2 && quotient == std::round(quotient)) return fmt::format("{:.0f} times as many", quotient);
    if (inverse > 2 && std::abs(inverse - std::round(inverse)) < 1e-9 * inverse)
        return fmt::format("1/{:.0f} as many", inverse);
    return "";
}

/// What all wrong ones share.
std::string in_common(const std::vector<SizePair>& wrong)
{
    const SizePair& first = wrong.front();
    const auto all = [&](const auto& holds) { return std::ranges::all_of(wrong, holds); };
    if (all([](const SizePair& one) { return one.yours == 0; })) return "is empty";
    std::set<double> different;
    for (const SizePair& one : wrong) different.insert(one.right);
    if (wrong.size() >= least_calls && different.size() > 1) {
        const double more = first.yours - first.right;
        if (all([&](const SizePair& one) { return one.yours - one.right == more; }))
            return fmt::format("has {} too {}", elements(std::abs(more)), more < 0 ? "few" : "many");
        const double quotient = first.yours / first.right;
        const bool is_same = all([&](const SizePair& one) {
            return one.right > 0 && std::abs(one.yours - quotient * one.right) < 1e-9 * one.right;
        });
        if (const std::string times = is_same ? times_as_many(quotient) : ""; !times.empty())
            return "has " + times + " elements as it should";
    }
    const bool is_one = all([&](const SizePair& one) { return one.yours == first.yours && one.right == first.right; });
    const std::string numbers =
        fmt::format("{} where {} {} right", elements(first.yours),
                    first.right == 0 ? "none" : fmt::format("{:.0f}", first.right), first.right == 1 ? "is" : "are");
    if (is_one) return "has " + numbers;
    const char* side = all([](const SizePair& one) { return one.yours < one.right; })   ? "too few elements"
                       : all([](const SizePair& one) { return one.yours > one.right; }) ? "too many elements"
                                                                                        : "a wrong number of elements";
    return fmt::format("has {} (first {})", side, numbers);
}

}

std::string sentence_of_sizes(const std::vector<SizePair>& calls)
{
    std::vector<SizePair> wrong;
    for (const SizePair& one : calls)
        if (one.yours != one.right) wrong.push_back(one);
    if (wrong.empty()) return "";
    return fmt::format("{} in {} of {} call{}", in_common(wrong), wrong.size(), calls.size(),
                       calls.size() == 1 ? "" : "s");
}

}
