#include "explain/code_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <umbral/record/block_trace.hpp>

#include "build/inspection.hpp"
#include "build/traced.hpp"
#include "explain/asked_alone.hpp"
#include "explain/asked_answers.hpp"
#include "explain/same_values.hpp"
#include "explain/samples.hpp"
#include "judge/explain/thresholds.hpp"
#include "judge/judges.hpp"
#include "question/passed_places.hpp"
#include "report/failing_order.hpp"
#include "text/printable.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_placed_checks = 3;  ///< for which it is looked for: those that are shown first
constexpr std::size_t most_other_cases = 4;    ///< other cases that are looked at with one
constexpr std::size_t most_seeds = 3;          ///< of which answers are looked at, where few are wrong
constexpr std::size_t most_fresh = 2;          ///< seeds on which it is confirmed
constexpr double most_place_seconds = 3;       ///< all runs of a unit together
constexpr std::size_t most_bytes = 160;        ///< of a line that is shown

using Places = std::vector<std::uint32_t>;
/// For each question the places that it came through, in the order in which it first did.
using PlacesOfQuestions = std::map<std::uint32_t, Places>;

/// The rows of a recording's "?blocks"; empty where it holds none, or what no run of ours writes.
std::vector<std::pair<std::uint32_t, std::uint32_t>> blocks_in(const RunOutcome& run)
{
    const Tensor* const tensor = tensor_of(run, std::string(blocks_of_questions));
    if (tensor == nullptr || !well_formed(*tensor) || tensor->element != Element::uint32 || tensor->components != 2 ||
        tensor->columns != 1)
        return {};
    std::vector<std::pair<std::uint32_t, std::uint32_t>> rows;
    const std::vector<double> numbers = to_doubles(*tensor);
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
        rows.emplace_back(static_cast<std::uint32_t>(numbers[i]), static_cast<std::uint32_t>(numbers[i + 1]));
    return rows;
}

/// Runs what was built to be traced, and knows the places in the student's files behind its blocks.
class Tracer {
public:
    Tracer(Worker& worker, const Exercise& exercise, const Built& traced)
        : worker_(worker), exercise_(exercise), traced_(traced), end_(worker.run_seconds() + most_place_seconds)
    {
    }

    /// Runs of all kinds are counted.
    [[nodiscard]] bool has_time() const { return worker_.spare_time().is_left() && worker_.run_seconds() < end_; }

    /// Of a run with the inputs of a seed, if it records the same as `plain` did under this name; null if it does not.
    [[nodiscard]] const PlacesOfQuestions* places(const Check& check, std::uint64_t seed, const RunOutcome& plain)
    {
        const auto key = std::pair(check.case_name, seed);
        auto found = runs_.find(key);
        if (found == runs_.end()) {
            Run run{worker_.run_traced(exercise_, traced_, check.case_name, seed), {}};
            run.places = placed(blocks_in(run.outcome));
            found = runs_.emplace(key, std::move(run)).first;
        }
        const Run& run = found->second;
        const Tensor* const yours = tensor_of(run.outcome, check.value);
        const Tensor* const graded = tensor_of(plain, check.value);
        const bool same = run.outcome.verdict == Verdict::ok && yours != nullptr && graded != nullptr &&
                          are_same_values(*yours, *graded);
        return same && !run.places.empty() ? &run.places : nullptr;
    }

    [[nodiscard]] const SourcePlace& place(std::uint32_t number) const { return places_.at(number); }

private:
    struct Run {
        RunOutcome outcome;
        PlacesOfQuestions places;
    };

    PlacesOfQuestions placed(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& blocks)
    {
        std::set<std::uint32_t> fresh;
        for (const auto& [question, block] : blocks)
            if (!numbers_.contains(block)) fresh.insert(block);
        constexpr std::size_t most_at_once = 4096;
        if (fresh.size() > most_at_once) return {};
        look_up({fresh.begin(), fresh.end()});
        PlacesOfQuestions result;
        for (const auto& [question, block] : blocks) {
            Places& passed = result[question];
            const auto number = numbers_.find(block);
            if (number == numbers_.end() || !number->second) continue;
            if (std::ranges::find(passed, *number->second) == passed.end()) passed.push_back(*number->second);
        }
        return result;
    }

    void look_up(const std::vector<std::uint32_t>& blocks)
    {
        if (blocks.empty()) return;
        const auto found = places_of(worker_.tools(), traced_.library, blocks);
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            std::optional<std::uint32_t>& number = numbers_[blocks[i]];
            if (i >= found.size() || !found[i] || !traced_.files.contains(found[i]->file)) continue;
            const auto known = std::ranges::find(places_, *found[i]);
            number = static_cast<std::uint32_t>(known - places_.begin());
            if (known == places_.end()) places_.push_back(*found[i]);
        }
    }

    Worker& worker_;
    const Exercise& exercise_;
    const Built& traced_;
    double end_;
    std::map<std::pair<std::string, std::uint64_t>, Run> runs_;
    std::map<std::uint32_t, std::optional<std::uint32_t>> numbers_;  ///< of blocks, by their addresses
    std::vector<SourcePlace> places_;
};

/// Looks for the place of one check.
class PlaceSearch {
public:
    PlaceSearch(Worker& worker, Tracer& tracer, const AskedCheck& asked)
        : worker_(worker), tracer_(tracer), asked_(asked)
    {
    }

    /// What of `seen` parts wrong from right ones, and of other inputs, too.
    [[nodiscard]] std::optional<PartingPlace> find(const std::vector<const Check*>& others, const CaseResults& cases,
                                                   const Built& built)
    {
        std::size_t used = 0;
        PassedPlaces seen;
        while (used < most_seeds && (used == 0 || lacks(seen, true))) add(asked_, input_seed(asked_, used++), seen);
        PassedPlaces with_others = seen;
        const auto add_others = [&] {
            for (std::size_t i = 0; i < std::min(others.size(), most_other_cases); ++i) {
                const CaseResult& one = cases.at(others[i]->case_name);
                CaseRuns runs(worker_, asked_.exercise, built, others[i]->case_name, one);
                const QuestionLog& log = worker_.questions(asked_.exercise, others[i]->case_name, one.seed);
                add({asked_.exercise, *others[i], runs, one, log, asked_.headers}, one.seed, with_others);
            }
        };
        if (lacks(seen, false)) {
            add_others();
            seen = with_others;
        }
        std::vector<PartingPlace> found = parting_places(seen);
        if (found.empty()) return std::nullopt;
        PassedPlaces fresh;
        for (std::size_t i = 0; i < most_fresh; ++i) add(asked_, input_seed(asked_, used + i), fresh);
        if (!lacks(fresh, true) && !lacks(fresh, false))
            std::erase_if(found, [&](const PartingPlace& one) { return !parts(place_among(one, fresh)); });
        // What only some of them come through is told from what follows from it by more of them.
        if (found.size() > 1 && with_others.wrong.size() == seen.wrong.size()) add_others();
        add(fresh, with_others);
        const auto best = std::ranges::min_element(
            found, {}, [&](const PartingPlace& one) { return error_of(place_among(one, with_others)); });
        return best == found.end() ? std::nullopt : std::optional(*best);
    }

private:
    [[nodiscard]] static bool lacks(const PassedPlaces& seen, bool wrong)
    {
        return static_cast<std::size_t>(std::ranges::count(seen.wrong, wrong)) < least_parted_questions;
    }

    static void add(const PassedPlaces& some, PassedPlaces& into)
    {
        into.wrong.insert(into.wrong.end(), some.wrong.begin(), some.wrong.end());
        into.places.insert(into.places.end(), some.places.begin(), some.places.end());
    }

    /// The questions with these inputs, of the function that most wrong answers are of.
    void add(const AskedCheck& asked, std::uint64_t seed, PassedPlaces& into)
    {
        if (!tracer_.has_time()) return;
        const AskedAnswers answers = asked_answers(worker_, asked, seed);
        const QuestionLog& log =
            seed == asked.result.seed ? asked.log : worker_.questions(asked.exercise, asked.check.case_name, seed);
        std::map<std::string, std::map<std::uint32_t, bool>> wrong;
        for (const AskedAnswer& one : answers.all)
            if (const QuestionKind* const kind = log.kind_of(one.question))
                wrong[kind->function][one.question] |= one.answer.wrong;
        if (wrong.empty()) return;
        const auto wrong_of = [](const auto& of_function) {
            return std::ranges::count(of_function.second, true, [](const auto& one) { return one.second; });
        };
        if (function_.empty()) function_ = std::ranges::max_element(wrong, {}, wrong_of)->first;
        const PlacesOfQuestions* const places = tracer_.places(asked.check, seed, asked.runs.plain(seed));
        if (places == nullptr) return;
        for (const auto& [question, is_wrong] : wrong[function_]) {
            const auto passed = places->find(question);
            // What runs no code of the student's own has nothing to show.
            if (passed == places->end()) continue;
            into.wrong.push_back(is_wrong);
            into.places.push_back(passed->second);
        }
    }

    Worker& worker_;
    Tracer& tracer_;
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
    if (place.of_wrong)
        return fmt::format("{} come through here, and {}", all_of(place.wrong_through, place.wrong, "wrong answers"),
                           some_of(place.right_through, place.right, "right ones"));
    return fmt::format("{} come through here, and {}", all_of(place.right_through, place.right, "right answers"),
                       some_of(place.wrong_through, place.wrong, "wrong ones"));
}

std::optional<CodePlace> code_place(const Built& built, const SourcePlace& place, const PartingPlace& parting)
{
    const auto file = built.files.find(place.file);
    if (file == built.files.end() || place.line < 1) return std::nullopt;
    std::string_view rest = file->second;
    for (int line = 1; line < place.line; ++line) {
        const std::size_t end = rest.find('\n');
        if (end == std::string_view::npos) return std::nullopt;
        rest.remove_prefix(end + 1);
    }
    rest = rest.substr(0, rest.find('\n'));
    const std::size_t indent = std::min(rest.find_first_not_of(" \t"), rest.size());
    std::string text = printable(rest.substr(indent), most_bytes);
    std::ranges::replace_if(
        text, [](char letter) { return letter == '\t' || letter == '\n'; }, ' ');
    const int column = place.column - static_cast<int>(indent);
    // What is written otherwise than it stands in the file has its columns elsewhere.
    const bool as_written = text == rest.substr(indent) && column <= static_cast<int>(text.size());
    return CodePlace{place.file, place.line, as_written ? std::max(0, column) : 0, std::move(text),
                     sentence_of(parting)};
}

bool is_explained(const UnitResult& result)
{
    return std::ranges::any_of(result.explanations, [](const Explanation& one) {
        return one.name.starts_with("mistake: ") && !one.hidden && one.fit == 1 &&
               one.confidence >= thresholds::very_sure;
    });
}

/// Failing checks as they are shown: what is seen before what is hidden.
std::vector<std::size_t> failing_checks(Worker& worker, const Exercise& exercise, const CaseResults& cases,
                                        const UnitResult& result)
{
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const CaseResult& one = cases.at(exercise.checks[i].case_name);
        const bool kept_something = result.checks[i].common == right_alone || result.checks[i].beside;
        if (fails(result.checks[i]) && !kept_something && one.reached && one.trouble().empty() &&
            may_repeat(worker, exercise, one))
            found.push_back(i);
    }
    std::ranges::stable_sort(
        found, {}, [&](std::size_t i) { return std::pair(result.checks[i].hidden, failing_order(&result.checks[i])); });
    if (found.size() > most_placed_checks) found.resize(most_placed_checks);
    return found;
}

/// Visible checks of other cases: first of what is called alike, which is asked alike, as a rule.
std::vector<const Check*> checks_beside(const Exercise& exercise, const CaseResults& cases, const Check& check)
{
    std::vector<const Check*> others;
    for (const Check& other : exercise.checks) {
        const CaseResult& one = cases.at(other.case_name);
        if (other.case_name != check.case_name && !other.relation && !is_picture(other) && !one.hidden && !one.beside &&
            one.reached && one.trouble().empty())
            others.push_back(&other);
    }
    std::ranges::stable_partition(others, [&](const Check* other) { return other->value == check.value; });
    return others;
}

}

void add_code_place(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                    UnitResult& result)
{
    if (is_explained(result)) return;
    const std::vector<std::size_t> checks = failing_checks(worker, exercise, cases, result);
    if (checks.empty()) return;
    const std::optional<Built> traced = build_traced(worker.tools(), exercise, built);
    if (!traced) return;
    Tracer tracer(worker, exercise, *traced);
    const std::string no_headers;
    for (const std::size_t i : checks) {
        if (!tracer.has_time()) return;
        const Check& check = exercise.checks[i];
        const CaseResult& one = cases.at(check.case_name);
        CaseRuns runs(worker, exercise, built, check.case_name, one);
        const QuestionLog& log = worker.questions(exercise, check.case_name, one.seed);
        const AskedCheck asked{exercise, check, runs, one, log, no_headers};
        PlaceSearch search(worker, tracer, asked);
        const auto found = search.find(checks_beside(exercise, cases, check), cases, built);
        if (!found) continue;
        result.checks[i].code_place = code_place(built, tracer.place(found->place), *found);
        return;
    }
}

}
