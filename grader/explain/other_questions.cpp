#include "explain/other_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "explain/question_words.hpp"
#include "explain/questions_in_turn.hpp"
#include "explain/weighed_questions.hpp"
#include "judge/explain/thresholds.hpp"
#include "text/joined.hpp"
#include "worker/interface_text.hpp"

namespace umbral::grader {
namespace {

/// How many questions a case is asked: what is tried must take no longer than people wait, about a second for a case.
/// Structs of many vectors can be misunderstood in hundreds of ways: of them `least` are asked if that takes
/// `most_seconds` at most, so that a slow machine finds what a fast one does, and `fewest` whatever it takes. Pictures
/// cost a hundred times what numbers do, and say less.
struct Patience {
    double seconds;
    double most_seconds;
    std::size_t fewest;
    std::size_t least;
    std::size_t most;

    /// After so many questions, which took `spent` seconds: may more be asked, which will take `next`?
    [[nodiscard]] bool allows(std::size_t tried, double spent, double next) const
    {
        return tried < fewest || spent + next < seconds || (tried < least && spent + next < most_seconds);
    }
};
constexpr Patience for_numbers{.seconds = 1, .most_seconds = 3, .fewest = 8, .least = 200, .most = 1500};
constexpr Patience for_pictures{.seconds = 1, .most_seconds = 3, .fewest = 8, .least = 24, .most = 24};
constexpr std::size_t most_asked_cases = 3;  ///< and others, while there is time to find more

/// A case that passes is asked only if it is small and takes no longer than this for all questions: it can speak
/// against a question, but others do too.
constexpr std::size_t most_passing_cells = 10'000;
constexpr double most_passing_seconds = 1;

/// All questions of a unit together take no longer than this. A changed mesh may make the reference walk round it for
/// ever, and each such run takes all that it may: rather no reason than one that is waited for.
constexpr double most_seconds_in_all = 10;
/// Of that, looking for those that fit. The rest is for asking all cases about them.
constexpr double most_seconds_to_find = 6;

const Patience& patience_with(const RunOutcome& plain) { return leaves_picture(plain) ? for_pictures : for_numbers; }

/// How many are asked before it is looked at what that took: as many as there is time for if each took as long as a
/// run.
std::size_t questions_in_time(const Patience& patience, const RunOutcome& plain)
{
    const double runs = patience.most_seconds / std::max(plain.cpu_seconds, 1e-4);
    return static_cast<std::size_t>(std::clamp(runs, double(patience.fewest), double(patience.most)));
}

/// Those that a failing check of this case speaks for.
std::vector<WeighedQuestion> fitting(Worker& worker, const Exercise& exercise, const CaseChecks& group,
                                     const std::string& headers, SpareTime& time)
{
    const RunOutcome& plain = worker.trusted(exercise, Answers::reference, group.name, group.result->seed);
    const QuestionLog& log = worker.questions(exercise, group.name, group.result->seed);
    std::map<std::vector<std::string>, bool> concerns;
    std::vector<QuestionInTurn> asked = questions_in_turn(log, headers);
    std::erase_if(asked, [&](const QuestionInTurn& one) {
        const std::vector<std::string> functions = functions_of(one.question);
        const auto [known, is_new] = concerns.try_emplace(functions, false);
        if (is_new)
            known->second = std::ranges::any_of(group.checks, [&](const FailingCheck& check) {
                return check.fails && may_concern(log, check, functions);
            });
        return !known->second;
    });
    const Patience& patience = patience_with(plain);
    asked.resize(std::min(asked.size(), patience.most));
    // What starting a run takes is no question's: if they cost less than they seem to, there is time for more.
    std::vector<WeighedQuestion> tried;
    const std::size_t most = questions_in_time(patience, plain);
    const double start = time.left();
    for (double last = 0; tried.size() < asked.size() && patience.allows(tried.size(), start - time.left(), last);) {
        const std::size_t first = tried.size();
        const double before = time.left();
        for (std::size_t i = first; i < std::min(first + most, asked.size()); ++i) tried.push_back({asked[i].question});
        weigh_all(worker, exercise, group, std::span(tried).subspan(first), time);
        last = before - time.left();
    }
    std::vector<WeighedQuestion> found;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < tried.size(); ++i)
        if (tried[i].fits) order.push_back(i);
    std::ranges::sort(order, {}, [&](std::size_t i) { return asked[i].declared; });
    for (const std::size_t i : order) {
        found.push_back(std::move(tried[i]));
        if (asked[i].everywhere) found.push_back({*asked[i].everywhere, found.back().tally});
    }
    return found;
}

/// Would asking so many questions of a case that passes take longer than it may?
bool is_too_long(Worker& worker, const Exercise& exercise, const CaseChecks& group, std::size_t questions)
{
    if (group.cells > most_passing_cells) return true;
    const RunOutcome& plain = worker.trusted(exercise, Answers::reference, group.name, group.result->seed);
    return plain.cpu_seconds * static_cast<double>(questions) > most_passing_seconds;
}

bool same(const Tally& a, const Tally& b)
{
    return a.for_it == b.for_it && a.against_it == b.against_it && a.bits == b.bits;
}

/// Of questions of which all cases so far say the same, the first: where an argument is not looked at at all, any
/// change of it fits.
template <class AreEqual>
void keep_first_of_equals(std::vector<WeighedQuestion>& candidates, const AreEqual& are_equal)
{
    std::vector<WeighedQuestion> kept;
    for (WeighedQuestion& one : candidates)
        if (std::ranges::none_of(kept, [&](const WeighedQuestion& other) { return are_equal(other, one); }))
            kept.push_back(std::move(one));
    candidates = std::move(kept);
}

bool are_same(const WeighedQuestion& one, const WeighedQuestion& other) { return same(one.tally, other.tally); }

/// What tells changes of one kind in one function apart is not worth the time.
bool are_same_kind(const WeighedQuestion& one, const WeighedQuestion& other)
{
    return are_same(one, other) && one.question.function == other.question.function &&
           far_fetched(one.question) == far_fetched(other.question);
}

/// What a mistake in a part of a function looks like: it explains some checks surely, and others not at all.
constexpr std::size_t least_explained = 2;
constexpr double least_bits_of_some = 60;

bool may_explain_some(const WeighedQuestion& one, std::size_t undecided)
{
    return far_fetched(one.question) < one_for_another && one.tally.for_it + undecided >= least_explained &&
           (undecided > 0 || one.tally.bits >= least_bits_of_some);
}

bool is_unsure(const WeighedQuestion& one) { return confidence(one.tally) < thresholds::least_sure; }

/// Where no question explains all: the one that explains some checks, if there is only one. Null if there is none.
const WeighedQuestion* only_one_for_some(const std::vector<WeighedQuestion>& candidates)
{
    if (!std::ranges::all_of(candidates, is_unsure)) return nullptr;
    const WeighedQuestion* best = nullptr;
    bool is_alone = true;
    for (const WeighedQuestion& one : candidates) {
        if (!may_explain_some(one, 0)) continue;
        is_alone = best == nullptr || one.tally.for_it > best->tally.for_it;
        if (is_alone) best = &one;
    }
    return is_alone ? best : nullptr;
}

/// Leaves only as many, the likeliest, as there is time to ask `groups` about, whose runs of the reference tell what
/// that takes; always one. A slow machine finds fewer reasons than a fast one, but not none.
void keep_what_time_allows(Worker& worker, const Exercise& exercise, std::span<const CaseChecks> groups,
                           const SpareTime& time, std::vector<WeighedQuestion>& candidates)
{
    double seconds = 1e-3;
    for (const CaseChecks& group : groups)
        if (group.failing > 0)
            seconds += worker.trusted(exercise, Answers::reference, group.name, group.result->seed).cpu_seconds;
    const auto most = static_cast<std::size_t>(std::max(1.0, time.left() / seconds));
    if (most < candidates.size()) candidates.resize(most);
}

/// Those of one function, or of all, whose reason explains most.
void keep_best_function(std::vector<WeighedQuestion>& candidates)
{
    const auto best = std::ranges::max_element(candidates, {}, [](const WeighedQuestion& one) {
        return confidence(one.tally) * static_cast<double>(one.failing);
    });
    const std::string function = best->question.function;
    std::erase_if(candidates, [&](const WeighedQuestion& one) { return one.question.function != function; });
}

/// A part taken for another, or several changes at once, are told only where a simpler question explains less.
void keep_simple(std::vector<WeighedQuestion>& candidates)
{
    const std::vector<WeighedQuestion> all = candidates;
    std::erase_if(candidates, [&](const WeighedQuestion& one) {
        const int so_far = far_fetched(one.question);
        return so_far >= one_for_another && std::ranges::any_of(all, [&](const WeighedQuestion& other) {
                   return far_fetched(other.question) < so_far && other.failing >= one.failing &&
                          confidence(other.tally) >= confidence(one.tally) - thresholds::equally_sure;
               });
    });
}

}

std::vector<Explanation> by_other_questions(Worker& worker, const Exercise& exercise,
                                            std::span<const CaseChecks> groups)
{
    // Pictures cost a hundred times what numbers do, and say less: they are asked where nothing else fails.
    const auto has_numbers = [&](const CaseChecks& group) {
        return !leaves_picture(worker.trusted(exercise, Answers::reference, group.name, group.result->seed));
    };
    std::vector<CaseChecks> asked;
    std::ranges::copy_if(groups, std::back_inserter(asked), has_numbers);
    if (std::ranges::none_of(asked, [](const CaseChecks& group) { return group.failing > 0; }))
        asked.assign(groups.begin(), groups.end());
    SpareTime time;
    time.allow(most_seconds_to_find);
    const std::string headers = interface_text(worker, exercise);
    std::vector<WeighedQuestion> candidates;
    std::size_t tried = 0;
    for (const CaseChecks& group : asked) {
        if (group.failing == 0 || !group.result->cause().empty()) continue;
        if (tried++ >= most_asked_cases && time.left() < for_numbers.seconds) continue;
        for (WeighedQuestion& candidate : fitting(worker, exercise, group, headers, time))
            if (std::ranges::find(candidates, candidate.question, &WeighedQuestion::question) == candidates.end())
                candidates.push_back(std::move(candidate));
    }
    // One that explains many checks of the case in which it was found is tried before one that explains few.
    std::ranges::stable_sort(candidates, {}, [](const WeighedQuestion& one) {
        return std::pair(far_fetched(one.question), -confidence(one.tally));
    });
    for (WeighedQuestion& one : candidates) one = {std::move(one.question)};
    time.allow(time.left() + most_seconds_in_all - most_seconds_to_find);
    std::size_t failing = 0;
    for (const CaseChecks& group : asked) failing += group.failing;
    std::size_t undecided = failing;
    std::size_t weighed = 0;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const CaseChecks& group = asked[i];
        undecided -= group.failing;
        if (group.failing == 0 && is_too_long(worker, exercise, group, candidates.size())) continue;
        if (weighed++ == most_asked_cases) keep_first_of_equals(candidates, are_same_kind);
        keep_what_time_allows(worker, exercise, std::span(asked).subspan(i), time, candidates);
        weigh_all(worker, exercise, group, candidates, time);
        std::erase_if(candidates, [&](const WeighedQuestion& one) {
            return most_confidence(one.tally, undecided) < thresholds::least_sure && !may_explain_some(one, undecided);
        });
    }
    keep_first_of_equals(candidates, are_same);
    std::vector<Explanation> found;
    // What not all cases were asked about might be spoken against by the others.
    if (candidates.empty() || !time.is_left()) return found;
    const auto add = [&](const WeighedQuestion& candidate, double sureness, const std::string& where) {
        const std::string words = in_words(candidate.question, headers);
        const double share = static_cast<double>(candidate.failing) / static_cast<double>(failing);
        found.push_back({std::string(question_reason) + words, where + sentence(candidate.question, words), sureness,
                         fit(candidate.tally) * std::min(share, 1.0)});
    };
    if (const WeighedQuestion* const some = only_one_for_some(candidates)) {
        add(*some, thresholds::least_sure, fmt::format("In {}: ", joined_with_and(some->speaking)));
        return found;
    }
    std::erase_if(candidates, is_unsure);
    if (candidates.empty()) return found;
    keep_simple(candidates);
    keep_best_function(candidates);
    // What other checks speak against is not so of all results.
    for (const WeighedQuestion& candidate : candidates)
        add(candidate, confidence(candidate.tally),
            candidate.tally.against_it > 0 ? fmt::format("In {}: ", joined_with_and(candidate.speaking)) : "");
    return found;
}

}
