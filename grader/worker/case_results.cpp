#include "worker/case_results.hpp"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

#include <algorithm>
#include <charconv>

#include "judge/explain/resemblances.hpp"
#include "judge/judges.hpp"
#include "judge/rules.hpp"
#include "model/caps.hpp"
#include "worker/past_crashes.hpp"
#include "worker/related.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {
namespace {

/// "recorded 4000 rows, expected 14": a value with far more cells than expected was not read at all.
std::string too_many(const std::string& value, const RunOutcome& student, const RunOutcome& expected)
{
    const auto found = student.recording.oversized.find(value);
    const Tensor* right = tensor_of(expected, value);
    if (found == student.recording.oversized.end() || right == nullptr) return "";
    const Oversized& shape = found->second;
    if (shape.columns == 1) return fmt::format("recorded {} rows, expected {}", shape.rows, right->rows);
    if (shape.rows == 1) return fmt::format("recorded {} bytes, expected {}", shape.columns, right->columns);
    return fmt::format("recorded {} x {} cells, expected {} x {}", shape.columns, shape.rows, right->columns,
                       right->rows);
}

/// Judges the answers before and between crashes, or of functions that are written. With one that is missing no check
/// is all right, however much it may forgive.
void judge_answers(const Check& check, const AnswersPastCrashes& answers, const Expected& expected, double control,
                   CheckResult& result)
{
    std::string trouble = std::move(result.message);
    take_judgement(check, judge(check, answers.tensor, *expected.value, expected.margin, expected.names), control,
                   result);
    const auto rows = static_cast<Millipoints>(expected.value->rows);
    const auto lost = static_cast<Millipoints>(answers.lost.size());
    result.score = std::min(result.score, result.max_score * (rows - lost) / std::max<Millipoints>(rows, 1));
    if (lost == 0) return;
    if (result.first_difference && result.first_difference->cell &&
        std::ranges::binary_search(answers.lost, *result.first_difference->cell))
        result.first_difference->yours = "no answer";
    result.message =
        lost < rows ? fmt::format("{} of {} rows have no answer: {}", lost, rows, trouble) : std::move(trouble);
}

/// Says of the first wrong value that it is none, where the unit refused what it was asked.
void add_refusal(const Check& check, const RunOutcome& student, CheckResult& result)
{
    if (!result.first_difference || !result.first_difference->cell) return;
    const auto refused = refusals_in(student, check.value);
    const auto found = refused.find(*result.first_difference->cell);
    if (found == refused.end() || found->second.empty()) return;
    const std::string& why = found->second;
    const std::string& where = result.first_difference->where;
    result.first_difference->yours = fmt::format("refused: {}", why);
    for (std::string* const text : {&result.message, &result.headline}) {
        if (text->empty()) continue;
        const bool says_where = text->find(where) != std::string::npos;
        *text += fmt::format("; {}yours refused: {}", says_where ? "" : fmt::format("at {} ", where), why);
    }
}

Unjudged unjudged_in(const CaseResult& one)
{
    if (!one.reached) return Unjudged::not_run;
    if (one.is_stub()) return Unjudged::unwritten;
    return one.student.verdict == Verdict::ok ? Unjudged::no : Unjudged::stopped;
}

}

bool is_endless(const RunOutcome& run, const Limits& limits)
{
    // A list that doubles its room has held half of the limit at least when it may not grow again.
    const bool filled = 8 * (run.peak_memory_kib >> 10) > std::int64_t{3} * limits.memory_mib;
    return run.verdict == Verdict::timeout || (run.verdict == Verdict::out_of_memory && filled);
}

bool may_run_another(const UnitBudget& budget, const CaseResults& cases, const Limits& limits)
{
    if (budget.left() <= 0) return false;
    std::ptrdiff_t endless = 0;
    double seconds = 0;
    for (const auto& [name, one] : cases) {
        if (!one.reached) continue;
        if (is_endless(one.student, limits) || slept_long(one.student, limits)) ++endless;
        seconds += SpareTime::cost_of(one.student);
    }
    return endless < caps::endless_cases && seconds < caps::unit_limits * limits.wall_seconds;
}

CaseResult not_reached(std::uint64_t seed, bool hidden)
{
    CaseResult one;
    one.seed = seed;
    one.hidden = hidden;
    one.reached = false;
    one.student.verdict = Verdict::timeout;
    return one;
}

std::string CaseResult::cause() const
{
    if (!reached)
        return fmt::format(
            "not reached: {} cases used up their time or memory, or all together {:g} times the time of one, or all "
            "units more than the {:g} s that they share; this one was not run and earns nothing until they take less",
            caps::endless_cases, caps::unit_limits, caps::shared_run_seconds);
    if (is_stub()) return std::string(in_words(Verdict::not_implemented));
    if (student.verdict == Verdict::ok) return "";
    std::string text = fmt::format("{}: {}", in_words(student.verdict), student.message);
    if (!place.empty()) text += " at " + one_line(place);
    return text;
}

std::vector<std::string> values_of(const Check& check)
{
    std::vector<std::string> values{check.value};
    if (check.relation) values.push_back(check.relation->to);
    if (check.relation && !check.relation->unlike.empty()) values.push_back(check.relation->unlike);
    return values;
}

std::string kept_from_judging(const Check& check, const CaseResult& one, const RunOutcome& expected)
{
    if (std::string cause = one.cause(); !cause.empty()) return cause;
    for (const std::string& value : values_of(check))
        if (std::string many = too_many(value, one.student, expected); !many.empty()) return many;
    return observed(check, one.student) == nullptr ? "nothing was recorded: the run was disturbed" : "";
}

CheckResult blank_result(const Check& check)
{
    CheckResult result;
    result.name = check.name;
    result.kind = check.judge;
    result.hard = check.hard;
    result.hidden = check.hidden;
    result.about = check.about;
    result.max_score = check.points;
    return result;
}

std::map<std::size_t, std::string> refusals_in(const RunOutcome& run, const std::string& value)
{
    std::map<std::size_t, std::string> found;
    std::istringstream lines{std::string(text_of(tensor_of(run, value + std::string(refusals::suffix))))};
    for (std::string line; std::getline(lines, line);) {
        std::size_t row = 0;
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), row);
        if (error == std::errc() && *end == '\t') found.emplace(row, one_line(end + 1));
    }
    return found;
}

bool leaves_picture(const RunOutcome& run)
{
    return std::ranges::any_of(run.recording.tensors, [](const auto& one) { return one.second.columns > 1; });
}

const Tensor* tensor_of(const RunOutcome& run, const std::string& name)
{
    const auto found = run.recording.tensors.find(name);
    return found == run.recording.tensors.end() ? nullptr : &found->second;
}

Expected expected_of(const Check& check, const RunOutcome& run)
{
    return {tensor_of(run, check.value), tensor_of(run, check.value + ".margin"),
            tensor_of(run, check.value + ".names")};
}

bool has_single_rows(const Check& check, const Tensor* student, const Tensor* expected)
{
    return student != nullptr && expected != nullptr && !check.relation && !judge_of(check).free_rows &&
           judge_of(check).plain_values && well_formed(*student) && well_formed(*expected) &&
           !shape_error(check, *student, *expected);
}

std::vector<RowState> single_rows(Check check, const Tensor& student, const Expected& expected)
{
    check.pairs = false;
    return row_states(check, student, *expected.value, expected.margin, rows_of(check));
}

const Tensor* observed(const Check& check, const RunOutcome& run)
{
    static const Tensor nothing;
    const Tensor* tensor = tensor_of(run, check.value);
    if (run.recording.oversized.contains(check.value)) return nullptr;
    return tensor == nullptr && judge_of(check).nothing_is_empty ? &nothing : tensor;
}

const Tensor* observed_beginning(const Check& check, const RunOutcome& run)
{
    const auto found = run.recording.oversized.find(check.value);
    if (found == run.recording.oversized.end()) return observed(check, run);
    return found->second.beginning.rows > 0 ? &found->second.beginning : nullptr;
}

CheckResult judge_check(const Check& check, const CaseResult& one, const RunOutcome& expected_run,
                        const CheckBasis& basis)
{
    CheckResult result = blank_result(check);
    const auto [expected, margin, names] = expected_of(check, expected_run);
    result.reference_error = basis.reference_error;
    result.message = kept_from_judging(check, one, expected_run);
    result.last_question = one.asked;
    if (!result.message.empty()) {
        const auto answers = answers_past_crashes(check, one, *expected);
        const bool answered = answers && answers->lost.size() < expected->rows;
        if (answers && (answered || !one.is_stub()))
            judge_answers(check, *answers, {expected, margin, names}, basis.control, result);
        if (!answered) result.unjudged = unjudged_in(one);
        const Tensor* beginning = observed_beginning(check, one.student);
        // Rows that come as they happen begin to differ somewhere.
        if (one.student.recording.oversized.contains(check.value) && beginning != nullptr &&
            judge_of(check).nothing_is_empty)
            result.first_difference = judge(check, *beginning, *expected, margin, names).first_difference;
        return result;
    }
    const Judgement judgement = check.relation
                                    ? RelationJudge(check, related_tensors(check, expected_run), margin, one.seed)
                                          .judge(related_tensors(check, one.student), names)
                                    : judge(check, *observed(check, one.student), *expected, margin, names);
    take_judgement(check, judgement, basis.control, result);
    add_refusal(check, one.student, result);
    if (is_by_chance(check)) result.seeds = {one.seed};
    return result;
}

CheckResult judge_check(const Check& check, const CaseResult& one, const RunOutcome& expected_run,
                        const RunOutcome& reference_run)
{
    return judge_check(check, one, expected_run, basis_of(check, expected_run, reference_run, one.seed));
}

void take_judgement(const Check& check, const Judgement& judgement, double control, CheckResult& result)
{
    result.score = points_for(check, judgement, control);
    result.error = judgement.error;
    result.message = judgement.message;
    result.headline = judgement.headline;
    result.metrics = judgement.metrics;
    result.metrics["right"] = judgement.right;
    result.first_difference = judgement.first_difference;
    result.sketch = judgement.sketch;
    result.borderline = judgement.borderline;
    if (judgement.right >= check.full && result.score < check.points && result.message.empty())
        result.message = "right, and so is what knows nothing of the problem: these inputs tell nothing";
}

}
