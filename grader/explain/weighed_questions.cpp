#include "explain/weighed_questions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "explain/other_answers.hpp"
#include "explain/question_words.hpp"
#include "explain/questions_in_turn.hpp"
#include "judge/explain/thresholds.hpp"
#include "worker/at_once.hpp"

namespace umbral::grader {
namespace {

/// What one run can hold.
constexpr std::size_t most_tensors = 240;
constexpr std::size_t most_tensor_bytes = std::size_t{32} << 20U;

/// Is an argument changed to a number that has to be rounded, which a student's own code need not do?
bool rounds(const OtherQuestion& question)
{
    constexpr std::array<std::string_view, 4> changes{"normalised", "squared", "subtracted from 1",
                                                      "replaced by its reciprocal"};
    return question.change.starts_with("turned from ") || std::ranges::find(changes, question.change) != changes.end();
}

/// Are all wrong answers the same yes or no, or none given? Then only which ones are wrong could agree, and of the many
/// questions that may be asked instead one or another changes just these.
bool errs_to_one_side(const FailingCheck& one)
{
    if (one.student == nullptr || one.expected == nullptr) return false;
    const std::vector<double> yours = numbers_or_nan(*one.student);
    const std::vector<double> right = numbers_or_nan(*one.expected);
    if (yours.size() != right.size()) return false;
    std::set<double> expected;
    std::set<double> wrong;
    bool is_none_given = true;
    for (std::size_t i = 0; i < yours.size(); ++i) {
        if (!std::isnan(right[i])) expected.insert(right[i]);
        if (equal_or_both_nan(yours[i], right[i])) continue;
        is_none_given = is_none_given && std::isnan(yours[i]);
        if (!std::isnan(yours[i])) wrong.insert(yours[i]);
    }
    return is_none_given || (expected.size() <= 2 && wrong.size() == 1);
}

/// Takes what the checks of one case say of the reference's answers to the other question. Where one mistake was made
/// in two functions, each has a reason of its own.
void weigh(const CaseChecks& group, const QuestionLog& log, const RunOutcome& run, WeighedQuestion& candidate)
{
    candidate.fits = false;
    const std::vector<std::string> functions = functions_of(candidate.question);
    for (const FailingCheck& one : group.checks) {
        if (!may_concern(log, one, functions)) continue;
        FailingCheck rounded = one;
        // In hard cases the student's own code rounds otherwise than the reference, too.
        if (rounds(candidate.question) || one.check->hard) rounded.rounding = thresholds::rounding_left;
        const Resemblance said = says_of(rounded, *group.result, run);
        if (said.says == Says::for_it && errs_to_one_side(one)) continue;
        candidate.tally += said;
        candidate.tally.hard_against += said.says == Says::against_it && one.check->hard ? 1 : 0;
        candidate.failing += one.fails ? 1 : 0;
        candidate.fits = candidate.fits || said.says == Says::for_it;
        if (said.says == Says::for_it) candidate.speaking.push_back(one.check->name);
    }
}

/// What is the same of all questions that are weighed in a case.
struct WeighedCase {
    const Exercise& exercise;
    const CaseChecks& group;
    const RunOutcome& plain;
    const QuestionLog& log;
};

/// As many as one run can hold. Where it does not come to its end, each half by itself.
void weigh_at_once(Worker& worker, const WeighedCase& one, std::span<WeighedQuestion> candidates, SpareTime& time)
{
    if (candidates.empty() || !time.is_left()) return;
    std::vector<OtherQuestion> others;
    for (const WeighedQuestion& candidate : candidates) others.push_back(candidate.question);
    const CaseChecks& group = one.group;
    const Limits limits =
        limits_for(one.exercise.limits, one.plain.cpu_seconds * static_cast<double>(1 + candidates.size()));
    const auto run = worker.answers_to_others(one.exercise, Answers::reference, group.name, group.result->seed,
                                              std::move(others), limits);
    time.spend(SpareTime::cost_of(*run));
    if (run->verdict != Verdict::ok && candidates.size() > 1) {
        weigh_at_once(worker, one, candidates.first(candidates.size() / 2), time);
        weigh_at_once(worker, one, candidates.subspan(candidates.size() / 2), time);
        return;
    }
    const std::vector<RunOutcome> runs = runs_of_others(*run, candidates.size());
    for (std::size_t i = 0; i < candidates.size(); ++i) weigh(group, one.log, runs[i], candidates[i]);
}

void weigh_in_turn(Worker& worker, const WeighedCase& one, std::span<WeighedQuestion> candidates, std::size_t most,
                   SpareTime& time)
{
    for (std::size_t i = 0; i < candidates.size(); i += most)
        weigh_at_once(worker, one, candidates.subspan(i, std::min(most, candidates.size() - i)), time);
}

}

bool may_concern(const QuestionLog& log, const FailingCheck& one, std::span<const std::string> functions)
{
    const auto rows = log.rows.find(one.check->value);
    if (rows == log.rows.end() || functions.front().empty()) return true;
    return std::ranges::any_of(rows->second, [&](std::uint32_t question) {
        const QuestionKind* const kind = question == 0 ? nullptr : log.kind_of(question - 1);
        return kind == nullptr || std::ranges::any_of(functions, [&](const std::string& function) {
                   return may_change(log, function, kind->function);
               });
    });
}

std::size_t questions_of_a_run(const Exercise& exercise, const RunOutcome& plain)
{
    // What one draw leaves in OpenGL's state must not reach the next.
    if (exercise.gl && leaves_picture(plain)) return 1;
    std::size_t bytes = 1;
    for (const auto& [name, tensor] : plain.recording.tensors) bytes += tensor.bytes.size() + tensor.present.size();
    const std::size_t tensors = std::max<std::size_t>(1, plain.recording.tensors.size());
    const auto in_time =
        static_cast<std::size_t>(0.2 * exercise.limits.wall_seconds / std::max(plain.cpu_seconds, 1e-3));
    return std::clamp<std::size_t>(std::min({most_tensors / tensors, most_tensor_bytes / bytes, in_time}), 1, 64);
}

void weigh_all(Worker& worker, const Exercise& exercise, const CaseChecks& group, std::span<WeighedQuestion> candidates,
               SpareTime& time)
{
    if (candidates.empty() || !time.is_left()) return;
    const WeighedCase one{exercise, group, worker.trusted(exercise, Answers::reference, group.name, group.result->seed),
                          worker.questions(exercise, group.name, group.result->seed)};
    const std::size_t most = questions_of_a_run(exercise, one.plain);
    // Whole runs for either worker.
    const std::size_t runs = (candidates.size() + most - 1) / most;
    const std::span<WeighedQuestion> some = candidates.first(std::min(candidates.size(), (runs + 1) / 2 * most));
    const std::span<WeighedQuestion> others = candidates.subspan(some.size());
    SpareTime first = time;
    SpareTime second = time;
    at_once(
        worker, [&](Worker& with) { weigh_in_turn(with, one, some, most, first); },
        [&](Worker& with) { weigh_in_turn(with, one, others, most, second); });
    time.spend(2 * time.left() - first.left() - second.left());
}

}
