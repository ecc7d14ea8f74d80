#include "batch/case_results.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "batch/related.hpp"

namespace umbral::grader {

std::string CaseResult::trouble() const
{
    if (is_stub()) return std::string(in_words(Verdict::not_implemented));
    if (student.verdict == Verdict::ok) return "";
    std::string text = fmt::format("{}: {}", in_words(student.verdict), student.message);
    if (!place.empty()) text += " at " + place;
    return text;
}

CheckResult blank_result(const Check& check)
{
    CheckResult result;
    result.name = check.name;
    result.kind = check.judge;
    result.hard = check.hard;
    result.hidden = check.hidden;
    result.max_score = check.points;
    return result;
}

const Tensor* tensor_of(const RunOutcome& run, const std::string& name)
{
    const auto found = run.recording.tensors.find(name);
    return found == run.recording.tensors.end() ? nullptr : &found->second;
}

const Tensor* observed(const Check& check, const RunOutcome& run)
{
    static const Tensor nothing;
    const Tensor* tensor = tensor_of(run, check.value);
    const bool by_rows = check.judge == JudgeKind::fragments || check.judge == JudgeKind::events;
    return tensor == nullptr && by_rows ? &nothing : tensor;
}

CheckResult judge_check(const Check& check, const CaseResult& one, const RunOutcome& expected_run, const RunOutcome& reference_run)
{
    CheckResult result = blank_result(check);
    const Tensor* expected = tensor_of(expected_run, check.value);
    const Tensor* reference = tensor_of(reference_run, check.value);
    if (expected == nullptr || reference == nullptr)
        throw std::runtime_error(fmt::format("check '{}': the driver recorded nothing called '{}'", check.name, check.value));
    const Tensor* margin = tensor_of(expected_run, check.value + ".margin");
    if (check.hard) result.reference_error = judge(check, *reference, *expected, margin).error;

    result.message = one.trouble();
    if (!result.message.empty()) return result;
    const Tensor* student = observed(check, one.student);
    if (student == nullptr) {
        result.message = "nothing was recorded: the run was disturbed";
        return result;
    }
    const Tensor* names = tensor_of(expected_run, check.value + ".names");
    Judgement judgement;
    BestControl control;
    if (check.relation) {
        const RelationJudge relation(check, related_tensors(check, expected_run), margin, one.seed);
        judgement = relation.judge(related_tensors(check, one.student), names);
        control = relation.best_control();
    } else {
        judgement = judge(check, *student, *expected, margin, names);
        control = best_control(check, *expected, margin, one.seed);
    }
    take_judgement(check, judgement, control.right, result);
    if (check.judge == JudgeKind::noise) result.seeds = {one.seed};
    return result;
}

void take_judgement(const Check& check, const Judgement& judgement, double control, CheckResult& result)
{
    result.score = points_for(check, judgement.right, control);
    result.error = judgement.error;
    result.message = judgement.message;
    result.metrics = judgement.metrics;
    result.metrics["right"] = judgement.right;
    result.first_difference = judgement.first_difference;
    result.sketch = judgement.sketch;
}

}
