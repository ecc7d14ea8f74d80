#include "batch/grade_unit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <umbral/core/random.hpp>

#include "batch/case_results.hpp"
#include "batch/evidence.hpp"
#include "batch/explain_unit.hpp"
#include "batch/pictures.hpp"
#include "batch/rerun.hpp"
#include "build/inspection.hpp"
#include "model/digest.hpp"

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
    UnitResult result = without_points(exercise, Verdict::grader_fault, "the grader failed, not your work; this unit does not count: " + what);
    result.max_score = 0;
    for (CheckResult& check : result.checks) check.max_score = 0;
    return result;
}

/// Cases in an order that differs from student to student but not between two gradings of the same submission: code that waits for
/// one special case cannot know which comes next.
std::vector<std::string> shuffled_cases(const Exercise& exercise, const SeedPlan& seeds)
{
    std::vector<std::string> cases = exercise.cases();
    Random random(case_seed(seeds.secret, seeds.course, seeds.student, exercise.id, "order of cases", seeds.attempt));
    for (std::size_t i = cases.size(); i > 1; --i) std::swap(cases[i - 1], cases[random.below(static_cast<std::uint32_t>(i))]);
    return cases;
}

Verdict verdict_of(const UnitResult& result, const CaseResults& cases)
{
    if (result.score == result.max_score) return Verdict::ok;
    if (result.score > 0) return Verdict::partial;
    const bool all_stubs = std::all_of(cases.begin(), cases.end(), [](const auto& entry) { return entry.second.is_stub(); });
    if (all_stubs) return Verdict::not_implemented;
    // Of several kinds of trouble, what was refused says most about the submission.
    const auto refused = [](const auto& entry) { return !entry.second.student.refused.empty(); };
    if (std::any_of(cases.begin(), cases.end(), refused)) return Verdict::blocked;
    const auto stopped = std::find_if(cases.begin(), cases.end(), [](const auto& entry) { return entry.second.student.verdict != Verdict::ok; });
    return stopped == cases.end() ? Verdict::wrong : stopped->second.student.verdict;
}

/// One line a kind of trouble: which cases it stopped, and what it was.
std::string troubles(const CaseResults& cases)
{
    std::map<std::string, std::vector<std::string>> by_text;
    for (const auto& [name, one] : cases) {
        // What a hidden case printed or threw may hold its inputs: the kind of trouble must do.
        const std::string trouble = one.hidden && one.student.verdict != Verdict::ok ? std::string(in_words(one.student.verdict)) : one.trouble();
        if (!trouble.empty())
            by_text[trouble].push_back(name);
        else if (!one.student.refused.empty())
            by_text[fmt::format("the sandbox refused {}", fmt::join(one.student.refused, ", "))].push_back(name);
    }
    std::string lines;
    for (const auto& [text, names] : by_text) lines += fmt::format("{}: {}\n", fmt::join(names, ", "), text);
    return lines;
}

std::string printed_text(const Exercise& exercise, const CaseResults& cases)
{
    std::string text;
    for (const std::string& name : exercise.cases()) {
        const auto found = cases.find(name);
        if (found == cases.end() || is_hidden_case(exercise, name) || found->second.student.output.empty()) continue;
        if (text.find(found->second.student.output) != std::string::npos) continue;
        text += found->second.student.output;
        if (text.back() != '\n') text += '\n';
    }
    return printable(text, std::size_t{64} << 10U);
}

UnitResult grade_built(Workshop& workshop, const Exercise& exercise, const Built& built, const GradeOptions& options)
{
    CaseResults cases;
    for (const std::string& name : shuffled_cases(exercise, options.seeds)) {
        CaseResult one;
        one.seed = options.seeds.seed_of(exercise, name);
        one.hidden = is_hidden_case(exercise, name);
        one.student = workshop.run(exercise, built, name, one.seed);
        if (one.student.verdict == Verdict::grader_fault) throw std::runtime_error(one.student.message);
        if (one.student.verdict == Verdict::crashed && !one.student.recording.frames.empty() && !built.library.empty())
            one.place = place_of(workshop.tools(), built.library, one.student.recording.frames);
        cases.emplace(name, std::move(one));
    }
    UnitResult result = without_points(exercise, Verdict::wrong, "");
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        CaseResult& one = cases.at(check.case_name);
        const RunOutcome& expected = workshop.trusted(exercise, judged_against(check), check.case_name, one.seed);
        const RunOutcome& reference = workshop.trusted(exercise, Tenant::reference, check.case_name, one.seed);
        result.checks[i] = judge_check(check, one, expected, reference);
        one.reference_seconds = reference.wall_seconds;
    }
    settle_borderline(workshop, exercise, built, cases, options, result);
    for (const CheckResult& check : result.checks) result.score += check.score;
    for (const auto& [name, one] : cases) {
        result.seconds += one.student.wall_seconds;
        result.reference_seconds += one.reference_seconds;
    }
    result.verdict = verdict_of(result, cases);
    result.message = troubles(cases);
    result.output = printed_text(exercise, cases);
    if (options.explain && result.verdict != Verdict::ok) result.explanations = explain_unit(workshop, exercise, result, cases);
    if (!options.artefacts.empty()) save_pictures(workshop, exercise, cases, options, result);
    collect_evidence(workshop, exercise, cases, options, result);
    return result;
}

}

namespace {

/// `word` tells seeds of one case apart; the name of a case is one line, so that no other case has this one's.
std::uint64_t seed_for(const SeedPlan& plan, const Exercise& exercise, const std::string& case_name, const std::string& word)
{
    return is_hidden_case(exercise, case_name) ? case_seed(plan.secret, plan.course, plan.student, exercise.id, case_name + word, plan.attempt)
                                               : case_seed("visible", plan.course, "", exercise.id, case_name + word, plan.attempt);
}

}

std::uint64_t SeedPlan::seed_of(const Exercise& exercise, const std::string& case_name) const { return seed_for(*this, exercise, case_name, ""); }

std::uint64_t SeedPlan::fresh_seed_of(const Exercise& exercise, const std::string& case_name) const { return seed_for(*this, exercise, case_name, "\nagain"); }

bool is_hidden_case(const Exercise& exercise, const std::string& case_name)
{
    return std::any_of(exercise.checks.begin(), exercise.checks.end(), [&](const Check& check) { return check.hidden && check.case_name == case_name; });
}

UnitResult grade_unit(Workshop& workshop, const Exercise& exercise, const Handed& handed, const GradeOptions& options)
{
    UnitResult result;
    try {
        workshop.forget_if_full();
        describe_unit(exercise, options);
        if (!handed.missing.empty()) {
            result = without_points(exercise, Verdict::missing, fmt::format("not handed in: {}", fmt::join(handed.missing, ", ")));
        } else if (!handed.refused.empty()) {
            result = without_points(exercise, Verdict::missing, "not read: " + handed.refused);
        } else if (equals_stub(handed.files, exercise)) {
            result = without_points(exercise, Verdict::not_implemented, "the file is still the stub");
        } else {
            const Built built = build(workshop.tools(), exercise, handed.files);
            result = built.verdict == Verdict::ok ? grade_built(workshop, exercise, built, options) : without_points(exercise, built.verdict, built.message);
        }
    } catch (const std::exception& fault) {
        result = grader_fault(exercise, fault.what());
    }
    result.seed = case_seed("visible", options.seeds.course, "", exercise.id, "", options.seeds.attempt);
    return result;
}

}
