#include <fmt/format.h>

#include <algorithm>

#include "bench/held_out.hpp"
#include "bench/percent.hpp"
#include "bench/unforeseen/unforeseen.hpp"

namespace umbral::grader {
namespace {

using Truth = ToldSentence::Truth;

bool says(const UnforeseenBug& bug, Truth truth)
{
    return std::ranges::any_of(bug.said, [truth](const ToldSentence& one) { return one.truth == truth; });
}

/// A bug that leaves values, with which sentences.
struct Counts {
    std::size_t all = 0;
    std::size_t stopped = 0;
    std::size_t question = 0;
    std::size_t reason = 0;
    std::size_t condition = 0;
    std::size_t answer = 0;
    std::size_t dependence = 0;
    std::size_t change = 0;
    std::size_t place = 0;
    std::size_t elsewhere = 0;  ///< a place that is not the changed one
    std::size_t told = 0;
    std::size_t wrong = 0;
    std::size_t untried = 0;
};

template <class Meant>
Counts counted(const std::vector<UnforeseenBug>& bugs, Meant meant)
{
    Counts counts;
    for (const UnforeseenBug& bug : bugs) {
        if (!meant(bug)) continue;
        if (bug.stopped) {
            ++counts.stopped;
            continue;
        }
        const auto has = [&](ToldSentence::Kind kind) {
            return std::ranges::any_of(
                bug.said, [kind](const ToldSentence& one) { return one.kind == kind && one.truth == Truth::holds; });
        };
        ++counts.all;
        counts.question += bug.has_question ? 1 : 0;
        counts.reason += has(ToldSentence::Kind::reason) ? 1 : 0;
        counts.condition += has(ToldSentence::Kind::condition) ? 1 : 0;
        counts.answer += has(ToldSentence::Kind::answer) ? 1 : 0;
        counts.dependence += has(ToldSentence::Kind::dependence) ? 1 : 0;
        counts.change += has(ToldSentence::Kind::change) ? 1 : 0;
        counts.place += has(ToldSentence::Kind::place) ? 1 : 0;
        counts.elsewhere +=
            std::ranges::any_of(bug.said,
                                [](const ToldSentence& one) {
                                    return one.kind == ToldSentence::Kind::place && one.truth == Truth::untried;
                                })
                ? 1
                : 0;
        counts.told += says(bug, Truth::holds) ? 1 : 0;
        counts.wrong += says(bug, Truth::fails) ? 1 : 0;
        counts.untried += says(bug, Truth::untried) ? 1 : 0;
    }
    return counts;
}

std::string line(const char* name, const Counts& counts)
{
    const auto share = [&](std::size_t part) {
        return fmt::format("{:>8} {:>5.1f} %", part, percent(part, counts.all));
    };
    return fmt::format("{:<22}{:>6}{:>9}{}{}{}{}{}{}{}{}{}{}{}\n", name, counts.all, counts.stopped,
                       share(counts.question), share(counts.reason), share(counts.condition), share(counts.answer),
                       share(counts.dependence), share(counts.change), share(counts.place), share(counts.elsewhere),
                       share(counts.told), share(counts.wrong), share(counts.untried));
}

std::string listed(const UnforeseenBug& bug, Truth truth)
{
    std::string text = fmt::format("  {}, {}\n", bug.unit, bug.bug);
    for (const ToldSentence& one : bug.said)
        if (one.truth == truth) text += fmt::format("    {}{}\n", one.check.empty() ? "" : one.check + ": ", one.words);
    return text;
}

}

bool meets_targets(const std::vector<UnforeseenBug>& bugs)
{
    const Counts all = counted(bugs, [](const UnforeseenBug&) { return true; });
    return percent(all.told, all.all) >= 65 && percent(all.wrong, all.all) < 1;
}

std::string unforeseen_table(const std::vector<UnforeseenBug>& bugs)
{
    std::string text = fmt::format("{:<22}{:>6}{:>9}", "", "bugs", "stopped");
    for (const char* const heading : {"question", "true reason", "true where", "true what", "true depends", "true with",
                                      "its line", "other line", "any", "false", "untried"})
        text += fmt::format("{:>17}", heading);
    text += '\n';
    text += line("one change", counted(bugs, [](const UnforeseenBug& bug) { return !bug.two; }));
    text += line("two changes", counted(bugs, [](const UnforeseenBug& bug) { return bug.two; }));
    text += line("units that tune", counted(bugs, [](const UnforeseenBug& bug) { return !held_out(bug.unit); }));
    text += line("units held out", counted(bugs, [](const UnforeseenBug& bug) { return held_out(bug.unit); }));
    text += line("all", counted(bugs, [](const UnforeseenBug&) { return true; }));
    const auto list = [&](const char* heading, auto meant, Truth truth) {
        std::string lines;
        for (const UnforeseenBug& bug : bugs)
            if (meant(bug)) lines += listed(bug, truth);
        if (!lines.empty()) text += fmt::format("\n{}\n{}", heading, lines);
    };
    list(
        "False with other inputs:", [](const UnforeseenBug& bug) { return says(bug, Truth::fails); }, Truth::fails);
    list(
        "Could not be tried, or another line than the changed one:",
        [](const UnforeseenBug& bug) { return says(bug, Truth::untried); }, Truth::untried);
    list(
        "Nothing was said of:", [](const UnforeseenBug& bug) { return !bug.stopped && bug.said.empty(); },
        Truth::holds);
    return text;
}

}
