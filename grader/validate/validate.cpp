#include "validate/validate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "judge/explain/confidence.hpp"
#include "judge/judges.hpp"
#include "manifest/statements.hpp"
#include "validate/column_findings.hpp"
#include "validate/fixed_inputs.hpp"
#include "validate/question_findings.hpp"
#include "validate/rubric_findings.hpp"
#include "worker/case_results.hpp"
#include "worker/known_solutions.hpp"
#include "worker/related.hpp"

namespace umbral::grader {
namespace {

using Report = std::function<void(const Finding&)>;

double percent(const UnitResult& result)
{
    return result.max_score == 0 ? 0
                                 : 100.0 * static_cast<double>(result.score) / static_cast<double>(result.max_score);
}

std::optional<double> hard_share(const UnitResult& result)
{
    Millipoints score = 0;
    Millipoints max_score = 0;
    for (const CheckResult& check : result.checks) {
        if (!check.hard) continue;
        score += check.score;
        max_score += check.max_score;
    }
    if (max_score == 0) return std::nullopt;
    return 100.0 * static_cast<double>(score) / static_cast<double>(max_score);
}

GradeOptions options_for(unsigned seed)
{
    GradeOptions options;
    options.questions = false;
    options.seeds = validation_seeds(seed);
    return options;
}

/// The first thing to say about a result that is not what it should be.
std::string complaint(const UnitResult& result)
{
    if (!result.message.empty()) return result.message;
    for (const CheckResult& check : result.checks)
        if (check.score != check.max_score) return fmt::format("{}: {}", check.name, check.message);
    return "";
}

Finding expect_all(Worker& worker, const Exercise& exercise, const std::string& subject, const Sources& sources,
                   unsigned seed)
{
    GradeOptions options = options_for(seed);
    options.other_inputs = true;  // what is right must be right for them too
    const UnitResult result = grade_unit(worker, exercise, {sources, {}, ""}, options);
    Finding finding{exercise.id, subject, seed, result.verdict == Verdict::ok, percent(result), "100", ""};
    finding.hard_share = hard_share(result);
    if (!finding.holds) finding.message = complaint(result);
    for (std::size_t i = 0; finding.holds && i < exercise.checks.size(); ++i) {
        const Check& check = exercise.checks[i];
        if (judge_of(check).too_narrow != nullptr)
            finding.message = judge_of(check).too_narrow(check, result.checks[i].metrics);
        finding.holds = finding.message.empty();
    }
    return finding;
}

/// The checks whose picture came out equal to the expected one (of noise: whose light did): their scenes cannot show
/// what is wrong.
std::vector<std::string> blind_checks(const UnitResult& result)
{
    std::vector<std::string> names;
    for (const CheckResult& check : result.checks)
        if (const Look look = judge_of(check).look;
            check.score == check.max_score && ((look == Look::colours && check.error == 0.0) || look == Look::light))
            names.push_back(check.name);
    return names;
}

Finding expect_mistake(Worker& worker, const Exercise& exercise, const KnownSolution& mistake, unsigned seed)
{
    const UnitResult result = grade_mistake(worker, exercise, mistake, options_for(seed));
    Finding finding{exercise.id,  "mistake: " + mistake.name, seed, false, percent(result), "", "", mistake.what,
                    mistake.hint, hard_share(result)};
    if (mistake.verdict) {
        finding.expected = std::string(to_string(*mistake.verdict));
        finding.holds = result.verdict == *mistake.verdict;
        finding.message =
            finding.holds ? "" : fmt::format("verdict {}: {}", to_string(result.verdict), complaint(result));
        return finding;
    }
    finding.expected = fmt::format("{:g}..{:g}", mistake.least_credit, mistake.most_credit);
    finding.blind = blind_checks(result);
    const bool in_range = finding.credit >= mistake.least_credit && finding.credit <= mistake.most_credit &&
                          result.score < result.max_score;
    const auto own = std::ranges::find(result.explanations, mistake_title(mistake.name), &Explanation::name);
    // Two mistakes that give the same results here are told as "either … or …".
    const bool explained = own != result.explanations.end() && (own == result.explanations.begin() || own->ambiguous);
    const std::string leak = mistake.rubric_line ? rubric_complaint(*mistake.rubric_line, result) : "";
    finding.holds = in_range && explained && leak.empty();
    if (result.score == result.max_score)
        finding.message = "no check tells it from the reference: the unit needs a scene or an input that shows it";
    else if (!in_range)
        finding.message = "credit out of range; " + complaint(result);
    else if (!leak.empty())
        finding.message = leak;
    else if (!explained)
        finding.message =
            result.explanations.empty() ? "not explained" : "explained as " + result.explanations.front().name;
    else
        finding.message =
            fmt::format("explained{}, confidence {:.2f}", own->ambiguous ? " as one of several" : "", own->confidence);
    return finding;
}

/// What each control gets for a check, and the best of them.
struct ControlShares {
    std::vector<std::pair<std::string, double>> right;
    double best = 0;
};

ControlShares control_shares(const Check& check, const RunOutcome& run, std::uint64_t seed)
{
    ControlShares shares;
    const auto [value, margin, names] = expected_of(check, run);
    if (check.relation) {
        const RelationJudge relation(check, related_tensors(check, run), margin, seed);
        for (const RelatedControl& control : relation.controls())
            shares.right.emplace_back(control.name, relation.judge(control.tensors()).right);
        shares.best = relation.best_control().right;
        return shares;
    }
    for (const auto& [name, tensor] : controls(check, *value, seed))
        shares.right.emplace_back(name, judge(check, tensor, *value, margin).right);
    shares.best = best_control(check, *value, margin, seed).right;
    return shares;
}

/// The best that knows nothing of the problem gets nothing: over the unit's checks, the largest share of a control that
/// is left after rescaling, and what it would have got without.
std::vector<Finding> expect_controls(Worker& worker, const Exercise& exercise, unsigned seed)
{
    const GradeOptions options = options_for(seed);
    std::map<std::string, Millipoints> earned;
    std::map<std::string, double> raw;
    for (const Check& check : exercise.checks) {
        const std::uint64_t case_seed = options.seeds.seed_of(exercise, check.case_name);
        const RunOutcome& run = worker.trusted(exercise, judged_against(check), check.case_name, case_seed);
        const Tensor* expected = tensor_of(run, check.value);
        if (expected == nullptr)
            throw std::runtime_error(fmt::format("{}: nothing recorded for check '{}'", exercise.id, check.name));
        // The forger cannot know a value, so it writes zeros or ones under every name, whichever pays better.
        Millipoints forged = 0;
        double forged_right = 0;
        const ControlShares shares = control_shares(check, run, case_seed);
        for (const auto& [name, right] : shares.right) {
            const Millipoints points = points_for(check, right, shares.best);
            earned[name] += points;
            raw[name] += right * static_cast<double>(check.points);
            if (name != "zeros" && name != "ones") continue;
            forged = std::max(forged, points);
            forged_right = std::max(forged_right, right);
        }
        earned["forger"] += forged;
        raw["forger"] += forged_right * static_cast<double>(check.points);
    }
    std::vector<Finding> findings;
    for (const auto& [name, points] : earned) {
        const double credit = 100.0 * static_cast<double>(points) / static_cast<double>(exercise.points);
        findings.push_back(
            {exercise.id, (name == "forger" ? name : "control: " + name), seed, points == 0, credit, "0",
             fmt::format("{:.1f} % before rescaling", 100 * raw[name] / static_cast<double>(exercise.points))});
    }
    return findings;
}

/// The cases that the checks name and the reference does not finish: mistyped in the manifest, as a rule. Empty if it
/// finishes all.
std::vector<Finding> expect_cases(Worker& worker, const Exercise& exercise, unsigned seed)
{
    const GradeOptions options = options_for(seed);
    std::vector<Finding> findings;
    for (const std::string& name : exercise.cases()) {
        try {
            (void)worker.trusted(exercise, Answers::reference, name, options.seeds.seed_of(exercise, name));
        } catch (const std::exception& error) {
            const std::string message = error.what();
            const std::size_t unknown = message.find("the driver has no case");
            findings.push_back(
                {exercise.id, "case: " + name, seed, false, 0, "a case",
                 unknown == std::string::npos ? message : "in exercise.json: " + message.substr(unknown)});
        }
    }
    return findings;
}

}

Finding expect_statements(const Exercise& exercise, unsigned seed)
{
    std::string missing;
    for (const Language& language : languages)
        if (!std::filesystem::is_regular_file(exercise.folder / language.statement))
            missing += (missing.empty() ? "" : ", ") + language.statement;
    return {exercise.id, "statements", seed, missing.empty(), 0, "both", missing.empty() ? "" : "missing: " + missing};
}

Finding expect_reference(const std::filesystem::path& reference, const Exercise& exercise, unsigned seed)
{
    std::string missing;
    for (const auto& [file, path] : reference_files(reference, exercise))
        if (!std::filesystem::is_regular_file(path)) missing += (missing.empty() ? "" : ", ") + path.string();
    return {exercise.id,
            "reference",
            seed,
            missing.empty(),
            0,
            "100",
            missing.empty() ? "" : "expected " + missing + ", which is not there"};
}

/// The stub with a line of one's own in each file: an untouched one is not even built.
Sources begun_stub(const Exercise& exercise)
{
    Sources sources = stub_sources(exercise);
    if (exercise.is_cpp())
        for (auto& [name, text] : sources) text += "\nnamespace {\n[[maybe_unused]] constexpr int begun = 1;\n}\n";
    return sources;
}

void validate_unit(Worker& worker, const Exercise& exercise, unsigned seed, const Report& report,
                   KnownMistakes mistakes)
{
    const auto guarded = [&](const std::string& subject, const auto& make) {
        try {
            make();
        } catch (const std::exception& error) {
            report({exercise.id, subject, seed, false, 0, "", error.what()});
        }
    };
    const std::filesystem::path& reference = worker.tools().reference;
    if (const Finding statements = expect_statements(exercise, seed); !statements.holds) report(statements);
    if (const Finding answers = expect_reference(reference, exercise, seed); !answers.holds) return report(answers);
    if (const std::vector<Finding> cases = expect_cases(worker, exercise, seed); !cases.empty()) {
        for (const Finding& one : cases) report(one);
        return;
    }
    guarded("reference",
            [&] { report(expect_all(worker, exercise, "reference", reference_sources(reference, exercise), seed)); });
    guarded("questions", [&] {
        for (const Finding& finding : expect_questions(worker, exercise, options_for(seed).seeds, seed))
            report(finding);
    });
    guarded("alternatives", [&] {
        for (const KnownSolution& other : alternatives_of(reference, exercise)) {
            Finding finding = expect_all(worker, exercise, "alternative: " + other.name, other.sources, seed);
            finding.what = other.what;
            report(finding);
        }
    });
    if (mistakes == KnownMistakes::graded)
        guarded("mistakes", [&] {
            const std::vector<KnownSolution> known = mistakes_of(reference, exercise);
            for (const Finding& finding : expect_rubric(exercise, known, seed)) report(finding);
            for (const KnownSolution& mistake : known) report(expect_mistake(worker, exercise, mistake, seed));
        });
    guarded("controls", [&] {
        for (const Finding& finding : expect_controls(worker, exercise, seed)) report(finding);
    });
    guarded("columns", [&] {
        for (const Finding& finding : expect_columns(worker, exercise, options_for(seed).seeds, seed)) report(finding);
    });
    guarded("fixed inputs", [&] {
        const Tables tables = mistakes == KnownMistakes::graded ? Tables::tried : Tables::passed_over;
        report(expect_few_fixed_inputs(worker, exercise, options_for(seed).seeds, seed, tables));
    });
    guarded("stub", [&] {
        const UnitResult stub = grade_unit(worker, exercise, {begun_stub(exercise), {}, ""}, options_for(seed));
        // Of a shader that is not written yet OpenGL says that it does not compile.
        const bool unwritten = stub.verdict == Verdict::not_implemented || stub.verdict == Verdict::compile_error;
        report({exercise.id, "stub", seed, unwritten && stub.score == 0, percent(stub), "not_implemented",
                std::string(to_string(stub.verdict))});
    });
}

}
