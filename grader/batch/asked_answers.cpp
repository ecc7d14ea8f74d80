#include "batch/asked_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "judge/explain/resemblances.hpp"
#include "judge/judges.hpp"
#include "judge/rows/columns.hpp"

namespace umbral::grader {
namespace {

/// Of one check; more say nothing new.
constexpr std::size_t most_answers = 4000;

/// "row 0, column 3" of a matrix, which lies column by column as GLM has it; else what the driver calls them.
std::vector<std::string> names_of_columns(const Check& check, const Tensor* names, std::size_t components)
{
    // Names of events and fragments are others.
    if (judge_of(check).free_rows) return {};
    const std::size_t side = components == 16 ? 4 : 3;
    if (&rows_of(check) != &matrix_rows() || side * side != components) return column_names(text_of(names), components);
    std::vector<std::string> entries;
    for (std::size_t i = 0; i < components; ++i)
        entries.push_back(fmt::format("(row {}, column {})", i % side, i / side));
    return entries;
}

std::vector<double> row_of(const TensorView& view, std::size_t row)
{
    if (!view.present(row)) return {};
    const auto cell = view.cell(row);
    return {cell.begin(), cell.end()};
}

void add_rows(const AskedCheck& asked, const QuestionLog& log, const Tensor& student, const Expected& expected,
              AskedAnswers& answers)
{
    const TensorView yours(student);
    const TensorView right(*expected.value);
    const std::vector<RowState> states = single_rows(asked.check, student, expected);
    answers.optional = right.optional();
    for (std::size_t row = 0; row < std::min(states.size(), most_answers); ++row) {
        const auto question = log.question_of(asked.check.value, row, states.size());
        if (states[row] == RowState::left_out || !question) continue;
        answers.all.push_back(
            {*question, row, {row_of(yours, row), row_of(right, row), states[row] == RowState::wrong}});
    }
}

/// The rows of a table that each question led to.
using RowsOfQuestions = std::map<std::uint32_t, std::vector<std::size_t>>;

RowsOfQuestions rows_of_questions(const QuestionLog& log, const std::string& value, std::size_t rows)
{
    RowsOfQuestions found;
    for (std::size_t row = 0; row < rows; ++row)
        if (const auto question = log.question_of(value, row, rows)) found[*question].push_back(row);
    return found;
}

/// Some rows of a table, as a table.
Tensor rows_of_table(const Tensor& table, const std::vector<std::size_t>& rows)
{
    Tensor some{table.element, static_cast<std::uint32_t>(rows.size()), 1, table.components, {}, {}};
    const std::size_t size = table.components * size_of(table.element);
    for (const std::size_t row : rows) {
        const auto bytes = std::span(table.bytes).subspan(row * size, size);
        some.bytes.insert(some.bytes.end(), bytes.begin(), bytes.end());
        if (!table.present.empty()) some.present.push_back(table.present[row]);
    }
    return some;
}

bool is_right(const Check& check, const Tensor& yours, const Tensor& right, const Tensor* margin)
{
    if (yours.rows == 0 || right.rows == 0) return yours.rows == right.rows;
    if (!judge_of(check).free_rows && yours.rows != right.rows) return false;
    return judge(check, yours, right, margin).right >= 1;
}

/// All rows of a question together. The student's run says itself which of its rows are whose: it runs again for that.
void add_groups(Worker& worker, const AskedCheck& asked, const QuestionLog& log, const Expected& expected,
                std::uint64_t seed, AskedAnswers& answers)
{
    const std::string& value = asked.check.value;
    const RunOutcome told = worker.run_told(asked.exercise, asked.built, asked.check.case_name, seed);
    const Tensor* student = observed(asked.check, told);
    if (told.verdict != Verdict::ok || student == nullptr || student->columns > 1 || expected.value->columns > 1)
        return;
    const Tensor& right = *expected.value;
    if (!well_formed(*student) || !well_formed(right) || row_shape_error(*student, right)) return;
    const RowsOfQuestions expected_rows = rows_of_questions(log, value, right.rows);
    const RowsOfQuestions yours = rows_of_questions(read_questions(told.recording.tensors), value, student->rows);
    RowsOfQuestions all = expected_rows;
    for (const auto& [question, rows] : yours) all.try_emplace(question);
    Check check = asked.check;
    check.pairs = false;
    const auto rows_in = [](const RowsOfQuestions& rows, std::uint32_t question) {
        const auto found = rows.find(question);
        return found == rows.end() ? std::vector<std::size_t>() : found->second;
    };
    for (const auto& [question, rows] : all) {
        if (answers.all.size() == most_answers) break;
        const Tensor one =
            student->rows == 0 ? rows_of_table(right, {}) : rows_of_table(*student, rows_in(yours, question));
        const Tensor other = rows_of_table(right, rows);
        const bool has_margin = expected.margin != nullptr && expected.margin->rows == right.rows &&
                                expected.margin->columns == 1 && well_formed(*expected.margin);
        const Tensor margin = has_margin ? rows_of_table(*expected.margin, rows) : Tensor();
        answers.all.push_back(
            {question,
             std::nullopt,
             {to_doubles(one), to_doubles(other), !is_right(check, one, other, has_margin ? &margin : nullptr)}});
    }
    answers.optional = true;
}

}

AskedAnswers asked_answers(Worker& worker, const AskedCheck& asked, std::uint64_t seed)
{
    const Check& check = asked.check;
    AskedAnswers answers;
    if (asked.result.hidden || check.relation || !judge_of(check).plain_values) return answers;
    const bool seen = seed == asked.result.seed;
    const RunOutcome& run = worker.trusted(asked.exercise, judged_against(check), check.case_name, seed);
    const QuestionLog& log = seen ? asked.log : worker.questions(asked.exercise, check.case_name, seed);
    const Expected expected = expected_of(check, run);
    if (expected.value == nullptr) return answers;
    answers.components = expected.value->components;
    answers.columns = names_of_columns(check, expected.names, answers.components);
    const RunOutcome again = seen ? RunOutcome() : worker.run(asked.exercise, asked.built, check.case_name, seed);
    const RunOutcome& student = seen ? asked.result.student : again;
    if (student.verdict != Verdict::ok) return answers;
    const Tensor* yours = observed(check, student);
    if (has_single_rows(check, yours, expected.value))
        add_rows(asked, log, *yours, expected, answers);
    else
        add_groups(worker, asked, log, expected, seed, answers);
    return answers;
}

}
