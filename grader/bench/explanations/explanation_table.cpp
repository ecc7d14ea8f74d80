#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "bench/explanations/explanations.hpp"
#include "bench/held_out.hpp"
#include "bench/percent.hpp"

namespace umbral::grader {
namespace {

constexpr std::array<std::pair<WorkKind, const char*>, 5> kinds{{{WorkKind::mistake, "mistake"},
                                                                 {WorkKind::rounded, "mistake, rounded otherwise"},
                                                                 {WorkKind::left_out, "mistake left out"},
                                                                 {WorkKind::disturbed, "results spoilt"},
                                                                 {WorkKind::two_mistakes, "two mistakes"}}};
constexpr std::array<std::pair<Said, const char*>, 7> outcomes{{{Said::right, "right"},
                                                                {Said::right_among, "right among"},
                                                                {Said::silent, "silent"},
                                                                {Said::true_statement, "true"},
                                                                {Said::twin, "twin"},
                                                                {Said::part, "part"},
                                                                {Said::wrong, "wrong"}}};

bool has_reason(WorkKind kind) { return kind == WorkKind::mistake || kind == WorkKind::rounded; }

/// How often what was said.
struct Share {
    std::map<Said, std::size_t> by_outcome;
    std::size_t all = 0;

    void add(Said said) { ++by_outcome[said], ++all; }
    [[nodiscard]] std::size_t of(Said said) const
    {
        const auto found = by_outcome.find(said);
        return found == by_outcome.end() ? 0 : found->second;
    }
    [[nodiscard]] double share(std::size_t count) const { return percent(count, all); }
    [[nodiscard]] std::size_t right() const { return of(Said::right) + of(Said::right_among); }
};

template <class Meant>
Share tally(const std::vector<ExplainedWork>& work, Meant meant)
{
    Share result;
    for (const ExplainedWork& one : work)
        if (meant(one)) result.add(one.said);
    return result;
}

std::string lines_for(const std::vector<ExplainedWork>& work, const char* heading)
{
    std::string text = fmt::format("{:<28}{:>7}", heading, "work");
    for (const auto& [said, name] : outcomes) text += fmt::format("{:>13}", name);
    text += "   first right, or wrong\n";
    for (const auto& [kind, name] : kinds) {
        const Share found = tally(work, [kind = kind](const ExplainedWork& one) { return one.kind == kind; });
        text += fmt::format("{:<28}{:>7}", name, found.all);
        for (const auto& [said, word] : outcomes) text += fmt::format("{:>13}", found.of(said));
        text += has_reason(kind) ? fmt::format("   right {:.1f} %\n", found.share(found.right()))
                                 : fmt::format("   wrong {:.2f} %\n", found.share(found.of(Said::wrong)));
    }
    const Share none = tally(work, [](const ExplainedWork& one) {
        return one.kind == WorkKind::left_out || one.kind == WorkKind::disturbed;
    });
    return text + fmt::format("{:<28}{:>7}   wrong {} of {}: {:.2f} %\n\n", "all that matches none", none.all,
                              none.of(Said::wrong), none.all, none.share(none.of(Said::wrong)));
}

}

const char* to_string(WorkKind kind)
{
    return std::ranges::find(kinds, kind, [](const auto& entry) { return entry.first; })->second;
}

const char* to_string(Said said)
{
    return std::ranges::find(outcomes, said, [](const auto& entry) { return entry.first; })->second;
}

bool meets_targets(const std::vector<ExplainedWork>& work, bool held_out_only)
{
    const auto among = [&](auto meant) {
        return tally(
            work, [&](const ExplainedWork& one) { return (!held_out_only || held_out(one.unit)) && meant(one.kind); });
    };
    const Share own = among([](WorkKind kind) { return kind == WorkKind::mistake; });
    const Share none = among([](WorkKind kind) { return kind == WorkKind::left_out || kind == WorkKind::disturbed; });
    return own.share(own.right()) >= 95 && none.share(none.of(Said::wrong)) < 1;
}

std::string explanation_table(const std::vector<ExplainedWork>& work)
{
    std::vector<ExplainedWork> tuning;
    std::vector<ExplainedWork> other_half;
    for (const ExplainedWork& one : work) (held_out(one.unit) ? other_half : tuning).push_back(one);
    std::string text =
        lines_for(work, "all units") + lines_for(tuning, "half that tunes") + lines_for(other_half, "half held out");
    return text + explanation_misses(work);
}

std::string explanation_misses(const std::vector<ExplainedWork>& work)
{
    std::string text;
    const auto list = [&](const char* heading, auto meant) {
        std::string lines;
        for (const ExplainedWork& one : work) {
            if (!meant(one)) continue;
            lines += fmt::format("  {} seed {}, {}: {}\n", one.unit, one.seed, to_string(one.kind), one.subject);
            for (const Explanation& said : one.explanations)
                lines += fmt::format("    {} {:.3f}, fits {:.2f}{}\n", said.name, said.confidence, said.fit,
                                     said.ambiguous ? ", ambiguous" : "");
        }
        if (!lines.empty()) text += fmt::format("{}\n{}\n", heading, lines);
    };
    list("Mistakes not told by their own reason:", [](const ExplainedWork& one) {
        return has_reason(one.kind) && one.said != Said::right && one.said != Said::right_among;
    });
    list("Told as one of several:",
         [](const ExplainedWork& one) { return one.kind == WorkKind::mistake && one.said == Said::right_among; });
    list("Wrongly explained:",
         [](const ExplainedWork& one) { return !has_reason(one.kind) && one.said == Said::wrong; });
    return text;
}

}
