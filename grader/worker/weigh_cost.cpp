#include "worker/weigh_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <umbral/record/cost.hpp>
#include <utility>

#include "judge/cost/answers.hpp"
#include "judge/cost/cost.hpp"
#include "judge/cost/outside_cost.hpp"
#include "judge/judges.hpp"
#include "judge/parameters.hpp"
#include "judge/rows/tensor_view.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {
namespace {

/// Of each side with each amount of work: enough for one that nothing ran beside.
constexpr int runs = 7;

/// Processor time of one run in milliseconds.
double milliseconds_of(const RunOutcome& run)
{
    if (run.verdict == Verdict::grader_fault) throw std::runtime_error(run.message);
    return 1000 * run.cpu_seconds;
}

/// One side of the comparison: the student's library, or the reference if there is none.
struct Side {
    const Built* built;
    OutsideCost least{nothing_yet};
    OutsideCost before{nothing_yet};  ///< of the work that this one's needs (CostParameters::after)

    /// What is the work's own.
    [[nodiscard]] OutsideCost own(bool needs_other) const
    {
        if (!needs_other) return least;
        return {least.nothing, std::max(least.nothing, least.first_sizes - before.first_work()),
                std::max(least.nothing, least.all_sizes - before.work())};
    }

    static constexpr OutsideCost nothing_yet{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(),
                                             std::numeric_limits<double>::max()};
};

/// " (of the numbers that sum it up, number 0 is 3197, expected 3200)"
std::string words_of(const WrongAnswer::Number& number)
{
    const auto [yours, expected] = telling_apart(
        [&](int digits) { return std::pair(number_text(number.yours, digits), number_text(number.expected, digits)); });
    return fmt::format(" (of the numbers that sum it up, number {} is {}, expected {})", number.place, yours, expected);
}

/// Which answer to the work is wrong, if any is.
std::optional<WrongAnswer> wrong_answer(const Check& check, const RunOutcome& student, const RunOutcome& reference)
{
    const std::string name = check.value + std::string(cost_answers_suffix);
    return first_wrong_answer(tensor_of(student, name), tensor_of(reference, name));
}

std::optional<std::string> measured_objection(Worker& worker, const Exercise& exercise, const Check& check,
                                              const Built& built, std::uint64_t seed, const std::vector<double>& sizes,
                                              std::string_view names, SpareTime& time)
{
    Side student{&built};
    Side reference{nullptr};
    bool left_out = false;
    const std::string& after = parameters_of<CostParameters>(check).after;
    const auto take = [&](Side& side, const std::string& name, std::size_t count, double& least) {
        RunOutcome run = worker.run_limited(exercise, side.built, check.case_name, seed, {name, count});
        const Tensor* table = tensor_of(run, name);
        left_out = left_out || (table == nullptr ? 0 : table->rows) != count;
        least = std::min(least, milliseconds_of(run));
        return run;
    };
    for (int i = 0; i < runs && (i == 0 || time.is_left()); ++i)
        for (const auto& [count, least] : {std::pair{std::size_t{0}, &OutsideCost::nothing},
                                           {sizes_to_compare(sizes), &OutsideCost::first_sizes},
                                           {sizes.size(), &OutsideCost::all_sizes}}) {
            const RunOutcome theirs = take(student, check.value, count, student.least.*least);
            const RunOutcome ours = take(reference, check.value, count, reference.least.*least);
            time.spend(std::max(theirs.cpu_seconds, theirs.wall_seconds));
            if (!after.empty()) {
                const RunOutcome other = take(student, after, count, student.before.*least);
                (void)take(reference, after, count, reference.before.*least);
                time.spend(std::max(other.cpu_seconds, other.wall_seconds));
            }
            // Whoever notices that the work is measured, and not looked at, could leave it.
            left_out = left_out || wrong_answer(check, theirs, ours);
        }
    if (left_out) return "when the work was asked for again, to measure its time, it was not done";
    return objection_from_outside(student.own(!after.empty()), reference.own(!after.empty()), sizes,
                                  parameters_of<CostParameters>(check).growth, names);
}

/// The table of costs that the reference recorded under this name in the check's case.
Cost costs(const Check& check, const RunOutcome& reference, const std::string& name)
{
    const Tensor* table = tensor_of(reference, name);
    std::optional<Cost> cost = table == nullptr ? std::nullopt : cost_of(*table);
    if (!cost)
        throw std::runtime_error(
            fmt::format("check '{}': the reference recorded no table of costs '{}' in its case", check.name, name));
    return *std::move(cost);
}

struct Objection {
    std::string words;
    bool to_answers = false;  ///< and not to the work
};

std::optional<Objection> objection_to(Worker& worker, const Exercise& exercise, const Check& check, const Built& built,
                                      const CaseResult& one)
{
    const RunOutcome& reference = worker.trusted(exercise, Answers::reference, check.case_name, one.seed);
    const Cost cost = costs(check, reference, check.value);
    if (const std::string& after = parameters_of<CostParameters>(check).after; !after.empty())
        (void)costs(check, reference, after);
    std::vector<double> sizes;
    for (const CostRow& row : cost) sizes.push_back(row.size);
    if (const auto wrong = wrong_answer(check, one.student, reference))
        return Objection{
            fmt::format("the answer for the size {} is not right{}: work that leads to no right answer earns nothing",
                        count_text(sizes[std::min(wrong->row, sizes.size() - 1)]),
                        wrong->number ? words_of(*wrong->number) : ""),
            true};
    if (!is_worth_measuring(milliseconds_of(one.student), milliseconds_of(reference))) return std::nullopt;
    // What ran beside may have cost one side more than the other: who loses points was too slow twice.
    const std::string_view names = text_of(expected_of(check, reference).names);
    // As long as one run may take: whoever takes all of that each time, and has the grader run it again and again, is
    // too slow by more than noise.
    SpareTime time;
    time.allow(std::min(exercise.limits.wall_seconds, worker.budget().left()));
    auto objection = measured_objection(worker, exercise, check, built, one.seed, sizes, names, time);
    if (objection && time.is_left())
        objection = measured_objection(worker, exercise, check, built, one.seed, sizes, names, time);
    if (!objection) return std::nullopt;
    return Objection{*std::move(objection)};
}

}

void weigh_costs(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                 UnitResult& result)
{
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        CheckResult& earned = result.checks[i];
        if (!judge_of(check).counts_work || earned.score == 0) continue;
        auto objection = objection_to(worker, exercise, check, built, cases.at(check.case_name));
        if (!objection) continue;
        earned.score = 0;
        earned.metrics["right"] = 0;
        earned.message = std::move(objection->words);
        if (objection->to_answers) earned.unjudged = Unjudged::wrong_answers;
    }
}

std::optional<Check> check_of_answers(const Check& check, const RunOutcome& student, const RunOutcome& expected)
{
    if (!judge_of(check).counts_work || !wrong_answer(check, student, expected)) return std::nullopt;
    Check answers = check;
    answers.value += cost_answers_suffix;
    answers.judge = JudgeKind{"numbers"};
    answers.tolerance = {};
    answers.tolerance.absolute = answers.tolerance.relative = answer_tolerance;
    return answers;
}

}
