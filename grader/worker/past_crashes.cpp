#include "worker/past_crashes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "judge/judges.hpp"
#include "question/log.hpp"

namespace umbral::grader {
namespace {

/// Each costs a run: so many questions, and then so many functions.
constexpr std::size_t most_questions = 8;
constexpr std::size_t most_functions = 3;
/// Of what a run might take that did not end: what it may take without the function in which it hung. Code that is slow
/// everywhere is stopped at one question today and at another tomorrow: only a loop that begins early, and does not
/// end, is told from it.
constexpr double part_without_loop = 0.25;
constexpr double least_without_loop = 0.5;  ///< seconds: what starting a run takes on a busy machine, several times

template <class Number>
void make_wrong(std::span<std::byte> bytes)
{
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(Number)) {
        Number number{};
        std::memcpy(&number, bytes.data() + at, sizeof number);
        if constexpr (std::is_floating_point_v<Number>)
            number = std::isnan(number) ? Number{0} : std::numeric_limits<Number>::quiet_NaN();
        else
            number ^= Number{1} << (8 * sizeof number - 2);
        std::memcpy(bytes.data() + at, &number, sizeof number);
    }
}

/// Gives a row a value that no tolerance takes for the expected one.
void make_wrong(const Tensor& expected, std::size_t row, Tensor& tensor)
{
    const std::size_t size = tensor.components * size_of(tensor.element);
    const auto bytes = std::span(tensor.bytes).subspan(row * size, size);
    const auto right = std::span(expected.bytes).subspan(row * size, size);
    std::ranges::copy(right, bytes.begin());
    if (!tensor.present.empty()) {
        tensor.present[row] = expected.present[row] == 0 ? 1 : 0;
        std::ranges::fill(bytes, std::byte{0});
        return;
    }
    switch (tensor.element) {
        case Element::float32: return make_wrong<float>(bytes);
        case Element::float64: return make_wrong<double>(bytes);
        case Element::int32:
        case Element::uint32: return make_wrong<std::uint32_t>(bytes);
        case Element::uint8: return make_wrong<std::uint8_t>(bytes);
    }
}

/// What was asked when a run ended, by the reference's run: the student's own may name anything. Empty where that was
/// asked something else at that place, because the driver goes another way after other answers.
std::string function_of_end(Worker& worker, const Exercise& exercise, const std::string& case_name, std::uint64_t seed,
                            const Recording& recording)
{
    const QuestionKind* kind = worker.questions(exercise, case_name, seed).kind_of(recording.asked - 1);
    return kind != nullptr && kind->function.starts_with(recording.function) ? kind->function : "";
}

/// Memory that was asked for and not given ends a run as any other exception does; a run that the kernel killed tells
/// nothing.
bool can_be_passed(const RunOutcome& run)
{
    const bool threw = run.verdict == Verdict::out_of_memory && run.recording.note == wire::Note::out_of_memory;
    return (threw || run.verdict == Verdict::crashed || run.verdict == Verdict::timeout) && run.recording.asked > 0;
}

}

void go_past_crashes(Worker& worker, const Exercise& exercise, const Built& built, const std::string& case_name,
                     CaseResult& one)
{
    if (!can_be_passed(one.student)) return;
    PassedOver passed_over;
    RunOutcome last = one.student;
    // The case that crashed and its repetitions take no longer than one run may, and the last of them, nor do all
    // repetitions of a unit: crashing late, again and again, would else cost twelve times the limit in each case.
    const bool hung = is_endless(last, exercise.limits);
    double seconds = hung ? 0 : last.wall_seconds;
    double allowed = exercise.limits.wall_seconds;
    // Each run takes more away, but whether code crashes may be up to chance.
    for (std::size_t runs = 0; can_be_passed(last) && runs <= most_questions + most_functions; ++runs) {
        const std::uint32_t question = last.recording.asked - 1;
        const bool endless = is_endless(last, exercise.limits);
        const bool again = std::ranges::find(passed_over.questions, question) != passed_over.questions.end();
        if (again || question >= passed_over.end) return;
        const auto function = [&] { return function_of_end(worker, exercise, case_name, one.seed, last.recording); };
        if (!endless && passed_over.questions.size() < most_questions) {
            passed_over.questions.push_back(question);
        } else if (passed_over.functions.size() == most_functions) {
            passed_over.end = question;
        } else {
            const std::string name = function();
            const bool is_new = passed_over.functions.emplace(name, question).second && !(endless && name.empty());
            // What is slow everywhere is stopped again in the same function, and where, is up to the clock.
            if (endless && runs > 0 && !is_new) return;
            if (!is_new)
                passed_over.end = question;
            else if (endless)
                one.hung.push_back(name);
        }
        if (endless) allowed = std::max(allowed * part_without_loop, least_without_loop);
        if (seconds > exercise.limits.wall_seconds || !worker.spare_time().is_left()) return;
        last = worker.run_past(exercise, built, case_name, one.seed, passed_over, allowed);
        seconds += last.wall_seconds;
    }
    if (last.verdict == Verdict::ok) one.past = std::move(last);
}

std::vector<std::string> functions_that_hung(const Exercise& exercise, const CaseResults& cases)
{
    std::vector<std::string> functions;
    for (const auto& [name, one] : cases) {
        if (!one.reached || !is_endless(one.student, exercise.limits)) continue;
        if (one.hung.empty()) return {};
        functions.insert(functions.end(), one.hung.begin(), one.hung.end());
    }
    return functions;
}

void run_without(Worker& worker, const Exercise& exercise, const Built& built, const std::string& case_name,
                 const std::vector<std::string>& functions, CaseResult& one)
{
    if (functions.empty() || !worker.spare_time().is_left()) return;
    PassedOver passed_over;
    for (const std::string& function : functions) passed_over.functions.emplace(function, 0);
    RunOutcome run = worker.run_past(exercise, built, case_name, one.seed, passed_over,
                                     exercise.limits.wall_seconds * part_without_loop);
    if (run.verdict == Verdict::ok) one.past = std::move(run);
}

std::string question_of_end(Worker& worker, const Exercise& exercise, const std::string& case_name,
                            const CaseResult& one)
{
    if (one.hidden || !can_be_passed(one.student)) return "";
    if (one.student.verdict == Verdict::timeout && !one.past) return "";
    const Recording& recording = one.student.recording;
    const std::uint32_t question = recording.asked - 1;
    if (function_of_end(worker, exercise, case_name, one.seed, recording).empty()) return "";
    return worker.code_of(exercise, case_name, one.seed, {question})[question];
}

std::vector<std::uint32_t> rows_without_answers(const Check& check, const RunOutcome& run)
{
    std::vector<std::uint32_t> rows;
    const Tensor* told = tensor_of(run, std::string(rows_without_answer) + check.value);
    if (told == nullptr || told->element != Element::uint32) return rows;
    for (std::size_t at = 0; at + sizeof(std::uint32_t) <= told->bytes.size(); at += sizeof(std::uint32_t)) {
        std::uint32_t row = 0;
        std::memcpy(&row, told->bytes.data() + at, sizeof row);
        rows.push_back(row);
    }
    return rows;
}

std::optional<AnswersPastCrashes> answers_past_crashes(const Check& check, const CaseResult& one,
                                                       const Tensor& expected)
{
    const Tensor* recorded = one.past ? tensor_of(*one.past, check.value) : nullptr;
    if (recorded == nullptr || recorded->columns != 1 || expected.columns != 1 || recorded->rows > expected.rows ||
        recorded->element != expected.element || recorded->components != expected.components ||
        recorded->present.empty() != expected.present.empty())
        return std::nullopt;
    const std::vector<std::uint32_t> told = rows_without_answers(check, *one.past);
    AnswersPastCrashes answers{*recorded, {told.begin(), told.end()}};
    std::erase_if(answers.lost, [&](std::size_t row) { return row >= recorded->rows; });
    for (std::size_t row = recorded->rows; row < expected.rows; ++row) answers.lost.push_back(row);
    std::ranges::sort(answers.lost);
    const auto twice = std::ranges::unique(answers.lost);
    answers.lost.erase(twice.begin(), twice.end());
    answers.tensor.rows = expected.rows;
    answers.tensor.bytes.resize(expected.bytes.size());
    answers.tensor.present.resize(expected.present.size());
    if (!has_single_rows(check, &answers.tensor, &expected)) return std::nullopt;
    for (const std::size_t row : answers.lost) make_wrong(expected, row, answers.tensor);
    return answers;
}

}
