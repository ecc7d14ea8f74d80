#include "explain/common_answer.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "question/list_patterns.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t least_denying = 16;  ///< wrong answers of another case that do not share what is told of these
constexpr std::size_t most_denying = 4;    ///< cases that are asked for it

/// The same answers, their numbers called as in `named`: the same is said of them in the same words.
AnswerTable named_as(const AnswerTable& named, AnswerTable answers)
{
    answers.columns = named.columns;
    answers.kinds = named.kinds;
    return answers;
}

/// What all wrong answers share, and the lists that they are together; numbers are called as in `named`.
std::vector<AnswerPattern> patterns_of(const AskedSample& sample, const AskedSample& named)
{
    std::vector<AnswerPattern> found = answer_patterns(named_as(named.answers, sample.answers));
    std::vector<const AnswerPair*> lists;
    for (const AnswerPair& one : sample.lists.answers)
        if (one.wrong) lists.push_back(&one);
    if (lists.size() < least_wrong) return found;
    // What a list is says more than what its rows are, one by one.
    std::vector<AnswerPattern> of_lists;
    for (std::string& words : list_patterns(sample.lists, lists)) of_lists.push_back({std::move(words)});
    found.insert(found.begin(), of_lists.begin(), of_lists.end());
    return found;
}

/// Are the right answers yes or no, each often enough that wrong ones of both kinds are to be expected?
bool are_mixed_bits(const AnswerTable& table)
{
    constexpr std::size_t least_part = 4;  ///< of all
    std::size_t yes = 0;
    for (const AnswerPair& one : table.answers) {
        if (one.expected.size() != 1 || (one.expected[0] != 0 && one.expected[0] != 1)) return false;
        yes += one.expected[0] == 1 ? 1 : 0;
    }
    return least_part * std::min(yes, table.answers.size() - yes) >= table.answers.size();
}

/// Keeps the patterns that many wrong answers of other cases have, too: what is so in one case only may come of its
/// inputs.
void keep_shared(OtherCases& others, const AskedSample& here, std::vector<AnswerPattern>& patterns)
{
    if (patterns.empty()) return;
    std::size_t tried = 0;
    others.each(here.function, [&](const AskedSample& sample) {
        if (sample.answers.components != here.answers.components || wrong_in(sample.answers) < least_denying)
            return true;
        // What overflows, or is not there, says nothing of what numbers are.
        if (are_comparable(here.answers) && !are_comparable(sample.answers)) return true;
        const std::vector<AnswerPattern> there = patterns_of(sample, here);
        std::erase_if(patterns, [&](const AnswerPattern& one) { return std::ranges::find(there, one) == there.end(); });
        return ++tried < most_denying && !patterns.empty();
    });
    // On which side wrong ones lie is the inputs' doing more often than the mistake's.
    if (tried == 0 && !are_mixed_bits(here.answers))
        std::erase_if(patterns, [](const AnswerPattern& one) { return one.tells == CommonTells::side; });
}

/// Keeps the patterns that the wrong answers to questions of other kinds have as well, which nothing is told of.
void keep_of_all_kinds(const AskedSample& seen, std::vector<AnswerPattern>& patterns)
{
    if (seen.others_wrong.empty()) return;
    AnswerTable all = seen.answers;
    all.facts.clear();
    std::ranges::copy(seen.others_wrong, std::back_inserter(all.answers));
    const std::vector<AnswerPattern> of_all = answer_patterns(all);
    std::erase_if(patterns, [&](const AnswerPattern& one) { return std::ranges::find(of_all, one) == of_all.end(); });
}

}

AnswerPattern common_answer(OtherCases& others, Samples& samples)
{
    std::vector<AnswerPattern> patterns = patterns_of(samples.seen(), samples.seen());
    keep_of_all_kinds(samples.seen(), patterns);
    std::size_t wrong = wrong_in(samples.seen().answers);
    const bool fixed = !patterns.empty() && samples.is_fixed();
    std::optional<AskedSample> pending;
    std::size_t confirmed = 0;
    for (std::size_t i = 1; i <= samples.fresh_sets() && !patterns.empty(); ++i) {
        AskedSample fresh = samples.fresh(i);
        // Of few nothing can be told: they are looked at together.
        if (pending && add(*pending, fresh)) fresh = *std::exchange(pending, std::nullopt);
        if (wrong_in(fresh.answers) < least_wrong) {
            pending = std::move(fresh);
            continue;
        }
        const std::vector<AnswerPattern> again = patterns_of(fresh, fresh);
        std::erase_if(patterns, [&](const AnswerPattern& one) { return std::ranges::find(again, one) == again.end(); });
        wrong += wrong_in(fresh.answers);
        if (++confirmed >= least_confirmed && (fixed || wrong >= enough_answers)) break;
    }
    if (confirmed == 0) patterns.clear();
    keep_shared(others, samples.seen(), patterns);
    return patterns.empty() ? AnswerPattern() : patterns.front();
}

std::optional<bool> holds_at(Worker& worker, const AskedCheck& asked, const std::string& pattern, std::uint64_t seed)
{
    const AskedSample fresh = asked_sample(worker, asked, seed);
    const std::vector<AnswerPattern> found = patterns_of(fresh, fresh);
    if (found.empty() && wrong_in(fresh.answers) < least_wrong) return std::nullopt;
    return std::ranges::find(found, pattern, &AnswerPattern::words) != found.end();
}

}
