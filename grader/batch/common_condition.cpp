#include "batch/common_condition.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "judge/rows/columns.hpp"
#include "question/conditions.hpp"
#include "question/names.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_rows = 4000;
constexpr std::size_t least_of_fixed = 6;  ///< questions on either side, where no fresh ones can confirm a condition
constexpr const char* right_answer = "the right answer";
constexpr const char* has_answer = "there being a right answer";

/// Rows of one check whose questions are of one kind: what is known of each, and which answers are wrong.
struct Sample {
    QuestionTable table;
    std::vector<bool> wrong;
};

/// What is known of the right answer in the row too.
void add_answer(const Tensor& expected, const TensorView& view, std::size_t row, std::vector<double>& numbers)
{
    if (view.optional()) numbers.push_back(view.present(row) ? 1 : 0);
    for (std::size_t i = 0; i < expected.components; ++i) numbers.push_back(view.present(row) ? view.cell(row)[i] : 0);
}

std::vector<std::string> answer_names(const Expected& expected, const TensorView& view)
{
    const std::size_t components = expected.value->components;
    const std::vector<std::string> columns = column_names(text_of(expected.names), components);
    std::vector<std::string> names;
    if (view.optional()) names.emplace_back(has_answer);
    for (std::size_t i = 0; i < components; ++i)
        names.push_back(components == 1   ? right_answer
                        : columns.empty() ? fmt::format("{}[{}]", right_answer, i)
                                          : fmt::format("{}.{}", right_answer, columns[i]));
    return names;
}

/// The rows whose questions are of the kind that most rows have.
Sample sample(const AskedCheck& asked, const QuestionLog& log, const Tensor& student, const Expected& expected)
{
    const Check& check = asked.check;
    const TensorView view(*expected.value);
    const std::vector<RowState> states = single_rows(check, student, expected);
    std::map<const QuestionKind*, std::vector<std::size_t>> by_kind;
    for (std::size_t row = 0; row < std::min(states.size(), most_rows); ++row) {
        if (states[row] == RowState::left_out) continue;
        const auto question = log.question_of(check.value, row, states.size());
        if (const QuestionKind* kind = question ? log.kind_of(*question) : nullptr) by_kind[kind].push_back(row);
    }
    Sample result;
    const auto most = std::ranges::max_element(by_kind, {}, [](const auto& one) { return one.second.size(); });
    if (most == by_kind.end()) return result;
    const auto& [kind, rows] = *most;
    const std::vector<std::string> parameters = parameter_names(asked.headers, kind->function);
    for (const std::string& place : kind->features) result.table.names.push_back(in_words(place, parameters));
    // That nothing is found where something is says more than what else is true of such questions.
    result.table.answers = result.table.names.size();
    result.table.words = kind->words;
    if (view.optional()) result.table.first = result.table.names.size();
    std::ranges::copy(answer_names(expected, view), std::back_inserter(result.table.names));
    for (const std::size_t row : rows) {
        std::vector<double> numbers = kind->questions.at(*log.question_of(check.value, row, states.size()));
        add_answer(*expected.value, view, row, numbers);
        result.table.numbers.push_back(std::move(numbers));
        result.wrong.push_back(states[row] == RowState::wrong);
    }
    return result;
}

bool has_both(const std::vector<bool>& wrong, std::size_t least)
{
    const auto count = static_cast<std::size_t>(std::ranges::count(wrong, true));
    return count >= least && wrong.size() - count >= least;
}

/// The same check on inputs that another seed gives; empty where the case cannot be asked again.
Sample fresh_sample(Worker& worker, const AskedCheck& asked)
{
    const Check& check = asked.check;
    const std::uint64_t seed = asked.result.seed ^ 0x9E3779B97F4A7C15U;
    const RunOutcome& run = worker.trusted(asked.exercise, judged_against(check), check.case_name, seed);
    const QuestionLog& log = worker.questions(asked.exercise, check.case_name, seed);
    const RunOutcome student = worker.run(asked.exercise, asked.built, check.case_name, seed);
    const Expected expected = expected_of(check, run);
    const Tensor* yours = observed(check, student);
    if (student.verdict != Verdict::ok || !has_single_rows(check, yours, expected.value)) return {};
    return sample(asked, log, *yours, expected);
}

/// "the right answer is nothing" is what people say.
void replace(std::string& text, const std::string& from, const std::string& to)
{
    if (const std::size_t place = text.find(from); place != std::string::npos) text.replace(place, from.size(), to);
}

std::string in_plain_words(const Condition& condition)
{
    std::string text = sentence_of(condition);
    const std::string answer = has_answer;
    for (const char* const end : {" is not 0", " is positive", " is 1"})
        replace(text, answer + end, "something is to be found");
    for (const char* const end : {" is 0 or negative", " is not 1", " is 0"})
        replace(text, answer + end, "nothing is to be found");
    return text;
}

}

std::string common_condition(Worker& worker, const AskedCheck& asked)
{
    const Check& check = asked.check;
    const RunOutcome& run = worker.trusted(asked.exercise, judged_against(check), check.case_name, asked.result.seed);
    const Expected expected = expected_of(check, run);
    const Tensor* student = observed(check, asked.result.student);
    if (asked.result.hidden || !has_single_rows(check, student, expected.value)) return "";
    const Sample seen = sample(asked, asked.log, *student, expected);
    const std::vector<Fact> facts = facts_of(seen.table);
    const std::optional<Condition> condition = simplest_condition(facts, seen.wrong);
    if (!condition) return "";
    const Sample fresh = fresh_sample(worker, asked);
    if (fresh.table.names != seen.table.names) return "";
    const bool same = fresh.table.numbers == seen.table.numbers;
    const bool holds = same ? has_both(seen.wrong, least_of_fixed) && condition->right_where == 0 &&
                                  condition->wrong_where == condition->wrong
                            : parts(*condition, facts_of(fresh.table), fresh.wrong);
    return holds ? in_plain_words(*condition) : "";
}

}
