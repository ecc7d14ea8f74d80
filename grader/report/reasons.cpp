#include "report/reasons.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "judge/explain/thresholds.hpp"

namespace umbral::grader {

const char* sure_words(double confidence)
{
    if (confidence >= thresholds::very_sure) return "very likely";
    return confidence >= thresholds::least_sure ? "probably" : "perhaps";
}

std::span<const Explanation> main_reasons(std::span<const Explanation> all)
{
    if (all.empty() || !all.front().ambiguous) return all.first(std::min<std::size_t>(all.size(), 1));
    const auto end = std::ranges::find(all, false, &Explanation::ambiguous);
    return all.first(static_cast<std::size_t>(end - all.begin()));
}

std::span<const Explanation> other_reasons(std::span<const Explanation> all)
{
    return all.subspan(main_reasons(all).size());
}

std::vector<std::string> reason_sentences(std::span<const Explanation> all)
{
    const auto reasons = main_reasons(all);
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < reasons.size(); ++i) {
        const char* lead = reasons.size() == 1 ? "" : i == 0 ? "Either: " : "or: ";
        sentences.push_back(lead + reasons[i].sentence);
    }
    if (!reasons.empty())
        sentences.back() +=
            fmt::format(" ({}{})", sure_words(reasons.back().confidence), reasons.size() == 1 ? "" : " one of these");
    return sentences;
}

std::string readable_reason(const Explanation& explanation)
{
    constexpr std::string_view prefix = "mistake: ";
    std::string name = explanation.name;
    if (name.starts_with(prefix)) name.erase(0, prefix.size());
    std::ranges::replace(name, '_', ' ');
    return name;
}

}
