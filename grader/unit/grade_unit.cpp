#include "unit/grade_unit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <umbral/core/random.hpp>

#include "explain/explain_unit.hpp"
#include "explain/loop_place.hpp"
#include "explain/practice_example.hpp"
#include "explain/questions.hpp"
#include "explain/unset_values.hpp"
#include "model/caps.hpp"
#include "model/digest.hpp"
#include "model/faults.hpp"
#include "model/rubric.hpp"
#include "text/printable.hpp"
#include "unit/beside_itself.hpp"
#include "unit/curve.hpp"
#include "unit/evidence.hpp"
#include "unit/long_questions.hpp"
#include "unit/other_inputs.hpp"
#include "unit/pictures.hpp"
#include "unit/rerun.hpp"
#include "unit/troubles.hpp"
#include "unit/worth_with_others.hpp"
#include "worker/case_results.hpp"
#include "worker/past_crashes.hpp"
#include "worker/student_case.hpp"
#include "worker/weigh_cost.hpp"

namespace umbral::grader {
namespace {

/// A result that earns nothing, with every check listed.
UnitResult without_points(const Exercise& exercise, Verdict verdict, std::string message)
{
    UnitResult result;
    result.id = exercise.id;
    result.digest = exercise.digest;
    result.verdict = verdict;
    result.max_score = exercise.points;
    result.message = std::move(message);
    for (const Check& check : exercise.checks) result.checks.push_back(blank_result(check));
    return result;
}

UnitResult grader_fault(const Exercise& exercise, const std::string& what)
{
    UnitResult result = without_points(exercise, Verdict::grader_fault, std::string(fault_preface) + what);
    result.max_score = 0;
    result.unscored = exercise.points;
    for (CheckResult& check : result.checks) check.max_score = 0;
    return result;
}

/// Cases in an order that differs from student to student but not between two gradings of the same submission: code
/// that waits for one special case cannot know which comes next.
std::vector<std::string> shuffled_cases(const Exercise& exercise, const SeedPlan& seeds)
{
    std::vector<std::string> cases = exercise.cases();
    Random random(case_seed(seeds.secret, seeds.course, seeds.student, exercise.id, "order of cases", seeds.attempt));
    for (std::size_t i = cases.size(); i > 1; --i)
        std::swap(cases[i - 1], cases[random.below(static_cast<std::uint32_t>(i))]);
    return cases;
}

/// Of several kinds of trouble, what was refused says most about the submission; and what visible cases ended by is
/// told before hidden ones', of which the student is told the kind only.
Verdict verdict_of(const UnitResult& result, const CaseResults& cases)
{
    if (result.score == result.max_score) return Verdict::ok;
    if (result.score > 0) return Verdict::partial;
    const bool all_stubs =
        std::all_of(cases.begin(), cases.end(), [](const auto& entry) { return entry.second.is_stub(); });
    if (all_stubs) return Verdict::not_implemented;
    for (const bool hidden : {false, true}) {
        const auto refused = [&](const auto& entry) {
            return entry.second.hidden == hidden && !entry.second.student.refused.empty();
        };
        if (std::any_of(cases.begin(), cases.end(), refused)) return Verdict::blocked;
        const auto failed = [&](const auto& entry) {
            return entry.second.hidden == hidden && entry.second.reached && entry.second.student.verdict != Verdict::ok;
        };
        const auto stopped = std::find_if(cases.begin(), cases.end(), failed);
        if (stopped != cases.end()) return stopped->second.student.verdict;
    }
    return Verdict::wrong;
}

/// Score and verdict, by what the checks have earned.
void add_up(const CaseResults& cases, UnitResult& result)
{
    result.score = 0;
    for (const CheckResult& check : result.checks) result.score += check.score;
    result.verdict = verdict_of(result, cases);
}

std::string printed_text(const Exercise& exercise, const CaseResults& cases)
{
    std::string text;
    for (const std::string& name : exercise.cases()) {
        const auto found = cases.find(name);
        if (found == cases.end() || found->second.hidden || found->second.student.output.empty()) continue;
        if (text.find(found->second.student.output) != std::string::npos) continue;
        text += found->second.student.output;
        if (text.back() != '\n') text += '\n';
    }
    return printable(text, caps::printed);
}

/// Was this run stopped by the clock while it hardly computed, or slept for long? It may have waited, or the machine
/// may have been busy with others, or with its disk.
bool was_starved(const RunOutcome& run, const Limits& limits)
{
    return (run.verdict == Verdict::timeout && run.cpu_seconds < 0.5 * limits.wall_seconds) || slept_long(run, limits);
}

/// Looks for what is said beside the grade. The grade stands, whatever goes wrong with that.
template <class Look>
void beside_the_grade(UnitResult& result, const Look& look)
{
    try {
        look();
    } catch (const std::exception& fault) {
        result.message += fmt::format("{}what else there is to say could not be found out, by a fault of Umbral's: {}",
                                      result.message.empty() ? "" : "\n", fault.what());
    }
}

/// `detail`, unless it is null, is given evidence.
UnitResult judged_in_full(Worker& worker, const Exercise& exercise, const Built& built, const GradeOptions& options,
                          html::UnitDetail* detail)
{
    if (built.verdict != Verdict::ok) {
        UnitResult result = without_points(exercise, built.verdict, built.message);
        result.settled = built.repeatable;
        return result;
    }
    CaseResults cases;
    worker.allow_spare_time(exercise.limits.wall_seconds);
    std::optional<std::vector<std::string>> hung;
    for (const std::string& name : shuffled_cases(exercise, options.seeds)) {
        const std::uint64_t seed = options.seeds.seed_of(exercise, name);
        if (may_run_another(worker.budget(), cases, exercise.limits)) {
            cases.emplace(name, run_case(worker, exercise, built, name, seed, options.explain));
            continue;
        }
        // What hangs costs nothing of what does not.
        CaseResult& one = cases.emplace(name, not_reached(seed, is_hidden_case(exercise, name))).first->second;
        if (!hung) hung = functions_that_hung(exercise, cases);
        run_without(worker, exercise, built, name, *hung, one);
    }
    UnitResult result = without_points(exercise, Verdict::wrong, "");
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        CaseResult& one = cases.at(check.case_name);
        const RunOutcome& expected = worker.trusted(exercise, judged_against(check), check.case_name, one.seed);
        result.checks[i] = judge_check(check, one, expected, worker.basis(exercise, check, one.seed));
        one.reference_seconds = worker.trusted(exercise, Answers::reference, check.case_name, one.seed).wall_seconds;
    }
    rerun_borderline(worker, exercise, built, cases, options, result);
    weigh_costs(worker, exercise, built, cases, result);
    if (options.other_inputs) expect_the_same_of_other_inputs(worker, exercise, built, cases, options, result);
    // Behind that, which is to weigh all that was earned: what is all right still.
    expect_the_same_beside_others(worker, exercise, built, cases, options, result);
    add_up(cases, result);
    // How long a hidden case took is up to its run, and may tell its inputs.
    for (const auto& [name, one] : cases) {
        if (one.hidden) continue;
        result.seconds += one.student.wall_seconds;
        result.reference_seconds += one.reference_seconds;
    }
    const bool starved = std::ranges::any_of(
        cases, [&](const auto& entry) { return was_starved(entry.second.student, exercise.limits); });
    // Without other units that take too long it may come out otherwise.
    result.settled = built.repeatable && !starved && worker.budget().left() > 0;
    result.message = troubles(cases);
    result.output = printed_text(exercise, cases);
    // What the sandbox refused is reason enough for no points.
    const bool explains = options.explain && result.verdict != Verdict::ok && result.verdict != Verdict::blocked;
    worker.allow_spare_time(exercise.limits.wall_seconds);
    if (explains)
        beside_the_grade(result, [&] {
            result.explanations = explain_unit(worker, exercise, result, cases);
            // What else would seem to explain them is chance.
            if (auto unset = by_unset_values(worker, exercise, built, result, cases)) {
                result.explanations = {std::move(unset->explanation)};
                result.message += unset->warnings;
            }
        });
    if (explains) beside_the_grade(result, [&] { result.message += loop_place(worker, exercise, built, cases); });
    beside_the_grade(result, [&] { result.curve = curve_of(worker, exercise, result, cases); });
    CaseResults practice;
    if (explains && (detail != nullptr || !options.artefacts.empty()))
        beside_the_grade(result, [&] { practice = practice_pictures(worker, exercise, built, cases, result); });
    if (!options.artefacts.empty()) save_pictures(worker, exercise, cases, practice, options, result);
    if (detail != nullptr) add_evidence(worker, exercise, cases, practice, options, result, *detail);
    if (explains && options.questions)
        beside_the_grade(result, [&] {
            add_questions(worker, exercise, built, cases, result, detail);
            if (!options.artefacts.empty()) save_long_questions(worker, exercise, cases, options, result);
        });
    // Behind all that says why checks fail: for these, what is right is right, whatever it hangs on.
    weigh_with_others(worker, exercise, cases, result);
    add_up(cases, result);
    return result;
}

/// Grades by `grade`; what goes wrong on our side becomes a result.
template <class Grade>
UnitResult guarded(Worker& worker, const Exercise& exercise, const GradeOptions& options, const Grade& grade)
{
    UnitResult result;
    try {
        worker.let_go();
        worker.bound_runs(UnitBudget(options.budgets.running));
        result = grade();
    } catch (const std::exception& fault) {
        result = grader_fault(exercise, fault.what());
    }
    // A fault has no lines: it is in no sum of points.
    if (result.verdict != Verdict::grader_fault) result.rubric = by_rubric(exercise, result.checks);
    result.seed = case_seed("visible", options.seeds.course, "", exercise.id, "", options.seeds.attempt);
    return result;
}

UnitResult grade_handed(Worker& worker, const Exercise& exercise, const Handed& handed, const GradeOptions& given,
                        html::UnitDetail* detail)
{
    GradeOptions options = given;
    UnitResult result = guarded(worker, exercise, options, [&] {
        if (options.seeds.work.empty()) options.seeds.work = work_digest(handed.files);
        if (!handed.missing.empty())
            return without_points(exercise, Verdict::missing,
                                  fmt::format("not handed in: {}", fmt::join(handed.missing, ", ")));
        if (!handed.refused.empty()) return without_points(exercise, Verdict::missing, "not read: " + handed.refused);
        if (const std::size_t bytes = bytes_of(handed.files); bytes > caps::unit_sources)
            return without_points(
                exercise, Verdict::missing,
                fmt::format("not read: the files of this unit take {} KiB together, and at most {} KiB are taken",
                            bytes >> 10U, caps::unit_sources >> 10U));
        if (equals_stub(handed.files, exercise))
            return without_points(exercise, Verdict::not_implemented, "the file is still the stub");
        Toolchain tools = worker.tools();
        if (options.budgets.compiling) tools.budget = std::make_shared<UnitBudget>(options.budgets.compiling);
        return judged_in_full(worker, exercise, build(tools, exercise, handed.files), options, detail);
    });
    // A fault's message is kept as it is: others look for its cause in it.
    if (!handed.notes.empty() && result.verdict != Verdict::grader_fault)
        result.message = fmt::format("{}\n{}", fmt::join(handed.notes, "\n"), result.message);
    return result;
}

}

UnitResult grade_unit(Worker& worker, const Exercise& exercise, const Handed& handed, const GradeOptions& options)
{
    return grade_handed(worker, exercise, handed, options, nullptr);
}

GradedUnit grade_with_evidence(Worker& worker, const Exercise& exercise, const Handed& handed,
                               const GradeOptions& options)
{
    GradedUnit graded{{}, describe(exercise)};
    graded.result = grade_handed(worker, exercise, handed, options, &graded.detail);
    return graded;
}

UnitResult grade_built(Worker& worker, const Exercise& exercise, const Built& built, const GradeOptions& options)
{
    return guarded(worker, exercise, options,
                   [&] { return judged_in_full(worker, exercise, built, options, nullptr); });
}

UnitResult grade_mistake(Worker& worker, const Exercise& exercise, const KnownSolution& mistake,
                         const GradeOptions& options)
{
    // An installation has it veiled and without debug information, so that it cannot be looked through.
    const std::filesystem::path library =
        unit_folder(worker.tools(), exercise.id) / "mistakes" / (mistake.name + ".so");
    return guarded(worker, exercise, options, [&] {
        const bool is_there = exercise.is_cpp() && std::filesystem::exists(library);
        Built built = is_there ? adopt(worker.tools(), exercise, mistake.sources, library)
                               : build(worker.tools(), exercise, mistake.sources);
        if (is_there || !exercise.is_cpp()) built.mistake = mistake.name;
        return judged_in_full(worker, exercise, built, options, nullptr);
    });
}

}
