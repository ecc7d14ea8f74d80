#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/judge.hpp"
#include "judge/rows/rows.hpp"
#include "model/exercise.hpp"
#include "model/scorecard.hpp"
#include "model/time_budget.hpp"
#include "run/spawner.hpp"
#include "worker/check_basis.hpp"

namespace umbral::grader {

/// The student's run of one case.
struct CaseResult {
    std::uint64_t seed = 0;
    bool hidden = false;
    bool reached = true;  ///< false: too many cases used up a limit before, so that this one was not run
    RunOutcome student;
    std::string place;  ///< where it crashed: "sphere.cpp:17"
    double reference_seconds = 0;
    std::vector<std::string> hung{};  ///< the functions that did not end, and the first of those that call them
    std::string asked{};              ///< the question in which the run ended, as code; empty if it is not known
    bool beside = false;  ///< `student` is the run beside itself, in which answers are wrong that are right without it
    std::optional<RunOutcome> past{};  ///< the same without the questions in which it crashed, or reached a stub

    [[nodiscard]] bool is_stub() const
    {
        return student.verdict == Verdict::ok && student.recording.not_implemented > 0;
    }
    /// What kept the case from being judged, in words; empty if nothing did.
    [[nodiscard]] std::string cause() const;
};
using CaseResults = std::map<std::string, CaseResult>;

/// Did a run sleep, neither computing nor waiting for a processor, for more than half of what it may take? No work of
/// these units waits for anything.
[[nodiscard]] inline bool slept_long(const RunOutcome& run, const Limits& limits)
{
    return run.wall_seconds - run.waited_seconds - run.cpu_seconds > limits.wall_seconds / 2;
}

/// Did a run take all the time that it may, or all the memory? An endless loop that keeps what it makes is as much of
/// one as any other, and filling memory takes long. Who asks for more than there is at once takes nothing.
[[nodiscard]] bool is_endless(const RunOutcome& run, const Limits& limits);

/// May another case of the unit be run? Not after caps::endless_cases of them were endless, or slept for half of their
/// time, nor after all took caps::unit_limits times one limit together: a submission in which everything hangs, or
/// nearly, costs no more. How often memory was filled is counted, since how long that takes is up to the machine. And
/// not when what the units of a submission share is used up.
[[nodiscard]] bool may_run_another(const UnitBudget& budget, const CaseResults& cases, const Limits& limits);
/// A case that was not run for that reason. It earns nothing.
[[nodiscard]] CaseResult not_reached(std::uint64_t seed, bool hidden);

/// What kept a check from being judged by its case's run, in words, and nothing if it can be: the case's trouble,
/// values of which far more rows were recorded than expected, or which are missing.
[[nodiscard]] std::string kept_from_judging(const Check& check, const CaseResult& one, const RunOutcome& expected);

/// The names under which a case records what this check looks at.
[[nodiscard]] std::vector<std::string> values_of(const Check& check);

/// A check that earned nothing yet.
[[nodiscard]] CheckResult blank_result(const Check& check);

/// Judges one check of a case against what was expected (the oracle's or the reference's run), with the best control
/// earning nothing.
[[nodiscard]] CheckResult judge_check(const Check& check, const CaseResult& one, const RunOutcome& expected,
                                      const CheckBasis& basis);
/// The same, with the basis worked out anew; throws as basis_of does.
[[nodiscard]] CheckResult judge_check(const Check& check, const CaseResult& one, const RunOutcome& expected,
                                      const RunOutcome& reference);

/// Puts what a judge found into a check's result, with the best control (the fraction right that it gets) earning
/// nothing.
void take_judgement(const Check& check, const Judgement& judgement, double control, CheckResult& result);

/// What the unit said when it refused what it was asked for rows of `value`, by the row's number.
[[nodiscard]] std::map<std::size_t, std::string> refusals_in(const RunOutcome& run, const std::string& value);

/// Did a run leave a picture or a buffer, and not only rows and texts?
[[nodiscard]] bool leaves_picture(const RunOutcome& run);

/// What a run recorded for this check, or null. Fragments and events come row by row: none at all is an empty table.
[[nodiscard]] const Tensor* observed(const Check& check, const RunOutcome& run);

/// The same, or the beginning of a table of which far more rows were recorded than expected: what is wrong begins
/// there.
[[nodiscard]] const Tensor* observed_beginning(const Check& check, const RunOutcome& run);

/// What trusted code recorded for a check; null where it recorded nothing. judge() says what margin and names are.
struct Expected {
    const Tensor* value = nullptr;
    const Tensor* margin = nullptr;
    const Tensor* names = nullptr;
};
[[nodiscard]] Expected expected_of(const Check& check, const RunOutcome& run);

/// Can the check's rows be compared one by one? Not with a relation, where rows are free, or where the values are not
/// compared themselves; nor if the two are of different shapes.
[[nodiscard]] bool has_single_rows(const Check& check, const Tensor* student, const Tensor* expected);
/// What became of each row, whether it counts as one of a pair or not. The two have single rows.
[[nodiscard]] std::vector<RowState> single_rows(Check check, const Tensor& student, const Expected& expected);

/// The recorded tensor of that name, or null.
[[nodiscard]] const Tensor* tensor_of(const RunOutcome& run, const std::string& name);

}
