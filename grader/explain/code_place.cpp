#include "explain/code_place.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>

#include "build/traced.hpp"
#include "explain/asked_alone.hpp"
#include "explain/asked_answers.hpp"
#include "explain/explained_checks.hpp"
#include "explain/other_cases.hpp"
#include "explain/samples.hpp"
#include "explain/source_line.hpp"
#include "explain/traced_runs.hpp"
#include "judge/judges.hpp"
#include "model/caps.hpp"
#include "question/passed_places.hpp"
#include "report/failing_order.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_placed_checks = 3;  ///< for which it is looked for: those that are shown first
constexpr std::size_t most_other_cases = 4;    ///< other cases that are looked at with one
constexpr std::size_t most_seeds = 3;          ///< of which answers are looked at, where few are wrong
constexpr std::size_t most_fresh = 2;          ///< seeds on which it is confirmed
constexpr double most_place_seconds = 3;       ///< all runs of a unit together
constexpr std::size_t most_bytes = 160;        ///< of a line that is shown

/// Looks for the place of one check.
class PlaceSearch {
public:
    PlaceSearch(Worker& worker, TracedRuns& traced, const AskedCheck& asked)
        : worker_(worker), traced_(traced), asked_(asked)
    {
    }

    /// The place that parts wrong answers of the check from right ones, with other inputs as well, and behind it those
    /// that part them as it does; `others` are checks of other cases.
    [[nodiscard]] std::vector<PartingPlace> find(const std::vector<const Check*>& others, const CaseResults& cases,
                                                 const Built& built)
    {
        std::size_t used = 0;
        PassedPlaces seen;
        while (used < most_seeds && (used == 0 || lacks(seen, true))) add(asked_, input_seed(asked_, used++), seen);
        PassedPlaces elsewhere;
        // Where all that is right is that nothing was answered, there is nothing to compare with.
        if (lacks(seen, false) || are_wrong_where_given(seen)) {
            elsewhere = among(others, cases, built);
            add(elsewhere, seen);
        }
        if (are_wrong_where_given(seen)) return {};
        std::vector<PartingPlace> found = parting_places(seen);
        const bool but_idle = found.empty();
        if (but_idle) {
            found = parting_places(without_idle(seen));
            for (PartingPlace& one : found) one.but_idle = true;
        }
        if (found.empty()) return {};
        PassedPlaces fresh;
        for (std::size_t i = 0; i < most_fresh; ++i) add(asked_, varied_seed(asked_, used + i), fresh);
        if (but_idle) fresh = without_idle(fresh);
        const bool is_confirmed = !lacks(fresh, true) && !lacks(fresh, false);
        std::erase_if(found, [&](const PartingPlace& one) {
            return is_confirmed ? !parts(place_among(one, fresh)) : are_few(one);
        });
        if (found.size() <= 1) return found;
        // What is reached only where a bug is, is told from what leads there by questions that turn off in between.
        if (elsewhere.empty()) elsewhere = among(others, cases, built);
        if (but_idle) elsewhere = without_idle(elsewhere);
        add(fresh, elsewhere);
        const auto strays = [&](const PartingPlace& one) { return strays_of(place_among(one, elsewhere)); };
        const PartingPlace best = *std::ranges::min_element(found, {}, strays);
        std::erase_if(found, [&, fewest = strays(best)](const PartingPlace& one) {
            return one.of_wrong != best.of_wrong || strays(one) != fewest;
        });
        return found;
    }

private:
    [[nodiscard]] static bool lacks(const PassedPlaces& seen, bool wrong)
    {
        return static_cast<std::size_t>(std::ranges::count(seen, wrong, &PassedQuestion::wrong)) <
               least_parted_questions;
    }

    /// The questions of other cases to the same function.
    [[nodiscard]] PassedPlaces among(const std::vector<const Check*>& others, const CaseResults& cases,
                                     const Built& built)
    {
        PassedPlaces all;
        for (std::size_t i = 0; i < std::min(others.size(), most_other_cases); ++i) {
            const CaseResult& one = cases.at(others[i]->case_name);
            CaseRuns runs(worker_, asked_.exercise, built, others[i]->case_name, one);
            const QuestionLog& log = worker_.questions(asked_.exercise, others[i]->case_name, one.seed);
            add({asked_.exercise, *others[i], runs, one, log, asked_.headers}, one.seed, all);
        }
        return all;
    }

    static void add(const PassedPlaces& some, PassedPlaces& into) { into.insert(into.end(), some.begin(), some.end()); }

    /// The questions with these inputs, of the function that most wrong answers are of.
    void add(const AskedCheck& asked, std::uint64_t seed, PassedPlaces& into)
    {
        if (!traced_.has_time()) return;
        const AskedAnswers answers = asked_answers(worker_, asked, seed);
        const QuestionLog& log = questions_at(worker_, asked, seed);
        std::map<std::string, std::map<std::uint32_t, bool>> wrong;
        std::set<std::uint32_t> given;
        std::set<std::uint32_t> busy;
        for (const AskedAnswer& one : answers.all) {
            if (const QuestionKind* const kind = log.kind_of(one.question))
                wrong[kind->function][one.question] |= one.answer.wrong;
            if (!answers.optional || !one.answer.yours.empty()) given.insert(one.question);
            if (!one.answer.expected.empty() || !one.answer.yours.empty()) busy.insert(one.question);
        }
        if (wrong.empty()) return;
        const auto wrong_of = [](const auto& of_function) {
            return std::ranges::count(of_function.second, true, [](const auto& one) { return one.second; });
        };
        if (function_.empty()) function_ = std::ranges::max_element(wrong, {}, wrong_of)->first;
        const PlacesOfQuestions* const places = traced_.places(asked.check, seed, asked.runs.plain(seed));
        if (places == nullptr) return;
        for (const auto& [question, is_wrong] : wrong[function_]) {
            const auto passed = places->find(question);
            // What runs no code of the student's own has nothing to show.
            if (passed == places->end()) continue;
            into.push_back({.wrong = is_wrong,
                            .places = passed->second.places,
                            .by_exception = passed->second.by_exception,
                            .given = given.contains(question),
                            .idle = !is_wrong && !busy.contains(question)});
        }
    }

    Worker& worker_;
    TracedRuns& traced_;
    const AskedCheck& asked_;
    std::string function_;
};

std::string sentence_of(const PartingPlace& place)
{
    const auto all_of = [](std::size_t some, std::size_t all, const char* which) {
        return some == all ? fmt::format("all {} {}", all, which) : fmt::format("{} of {} {}", some, all, which);
    };
    const auto some_of = [&](std::size_t some, std::size_t all, const char* which) {
        return some == 0 ? fmt::format("none of the {} {}", all, which) : all_of(some, all, which);
    };
    const std::string but_idle = place.but_idle ? " that are not empty" : "";
    if (place.of_wrong)
        return fmt::format("{} come through here, and {}",
                           all_of(place.wrong_through, place.wrong, "calls with wrong answers"),
                           some_of(place.right_through, place.right, "with right ones")) +
               but_idle;
    return fmt::format("{} come through here, and {}",
                       all_of(place.right_through, place.right, ("calls with right answers" + but_idle).c_str()),
                       some_of(place.wrong_through, place.wrong, "with wrong ones"));
}

/// "line 29", "lines 29 and 44"
std::string lines_in_words(const std::vector<int>& lines)
{
    const std::vector<int> others(lines.begin(), std::prev(lines.end()));
    return others.empty() ? fmt::format("line {}", lines.back())
                          : fmt::format("lines {} and {}", fmt::join(others, ", "), lines.back());
}

/// "; so they do through lines 29 and 44": where code that the same calls come through stands elsewhere, and where an
/// equal return does.
std::string also_through(const SourcePlace& here, const std::vector<PartingPlace>& all, const TracedRuns& traced,
                         std::string_view file)
{
    constexpr int same_block = 1;  // lines that follow each other run together
    constexpr std::size_t most_lines = 3;
    std::set<int> lines;
    for (const PartingPlace& one : all) {
        const SourcePlace& place = traced.place(one.place);
        if (place.file != here.file) continue;
        const auto is_near = [&](int line) { return std::abs(line - place.line) <= same_block; };
        if (!is_near(here.line) && std::ranges::none_of(lines, is_near)) lines.insert(place.line);
    }
    std::string words;
    if (!lines.empty() && lines.size() <= most_lines)
        words = "; so they do through " + lines_in_words({lines.begin(), lines.end()});
    const std::vector<int> returns = equal_returns(file, here.line, here.column);
    if (!returns.empty() && returns.size() <= most_lines)
        words += "; the same return stands in " + lines_in_words(returns);
    return words;
}

std::optional<CodePlace> code_place(const Built& built, const TracedRuns& traced, const std::vector<PartingPlace>& all)
{
    const PartingPlace& parting = all.front();
    const SourcePlace& place = traced.place(parting.place);
    const auto file = built.files.find(place.file);
    if (file == built.files.end()) return std::nullopt;
    const std::optional<std::string_view> line = source_line(file->second, place.line);
    if (!line) return std::nullopt;
    const std::size_t indent = std::min(line->find_first_not_of(" \t"), line->size());
    // Where right ones alone go, a part of a condition is where their inputs go.
    if (!parting.of_wrong && decides_within(*line)) return std::nullopt;
    std::string text = one_line(line->substr(indent), most_bytes);
    const int column = place.column - static_cast<int>(indent);
    // What is written otherwise than it stands in the file has its columns elsewhere.
    const bool as_written = text == line->substr(indent) && column <= static_cast<int>(text.size());
    return CodePlace{place.file, place.line, as_written ? std::max(0, column) : 0, std::move(text),
                     sentence_of(parting) + also_through(place, all, traced, file->second)};
}

/// Failing checks as they are shown: what is seen before what is hidden.
std::vector<std::size_t> failing_checks(Worker& worker, const Exercise& exercise, const CaseResults& cases,
                                        const UnitResult& result)
{
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const CaseResult& one = cases.at(exercise.checks[i].case_name);
        // Of estimates by chance no single one is wrong or right.
        if (fails(result.checks[i]) && !keeps_something(result.checks[i]) && !is_by_chance(exercise.checks[i]) &&
            one.reached && one.cause().empty() && may_repeat(worker, exercise, one))
            found.push_back(i);
    }
    std::ranges::stable_sort(
        found, {}, [&](std::size_t i) { return std::pair(result.checks[i].hidden, failing_order(&result.checks[i])); });
    if (found.size() > most_placed_checks) found.resize(most_placed_checks);
    return found;
}

}

void add_code_place(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                    UnitResult& result)
{
    if (std::ranges::any_of(result.explanations, explains_all)) return;
    std::vector<std::size_t> checks = failing_checks(worker, exercise, cases, result);
    // A line of the branch that such questions take says no more, and is often as right as any.
    std::erase_if(checks, [&](std::size_t i) { return result.checks[i].told_by_question; });
    if (checks.empty()) return;
    const std::optional<Built> traced = build_traced(worker.tools(), exercise, built);
    if (!traced) return;
    TracedRuns traced_runs(worker, exercise, *traced, most_place_seconds);
    const std::string no_headers;
    for (const std::size_t i : checks) {
        if (!traced_runs.has_time()) return;
        const Check& check = exercise.checks[i];
        const CaseResult& one = cases.at(check.case_name);
        CaseRuns runs(worker, exercise, built, check.case_name, one);
        const QuestionLog& log = worker.questions(exercise, check.case_name, one.seed);
        const AskedCheck asked{exercise, check, runs, one, log, no_headers};
        PlaceSearch search(worker, traced_runs, asked);
        const auto found = search.find(checks_beside(exercise, cases, check), cases, built);
        if (found.empty()) continue;
        result.checks[i].code_place = code_place(built, traced_runs, found);
        if (result.checks[i].code_place) return;
    }
}

}
