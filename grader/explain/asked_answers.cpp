#include "explain/asked_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "explain/some_rows.hpp"
#include "explain/value_in_list.hpp"
#include "judge/explain/resemblances.hpp"
#include "judge/judges.hpp"
#include "judge/rows/columns.hpp"
#include "judge/rows/rows.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

/// Of one check; more say nothing new.
constexpr std::size_t most_answers = 4000;

/// What the driver calls them, or the places in a matrix.
std::vector<std::string> names_of_columns(const Check& check, const Tensor* names, std::size_t components)
{
    const JudgeRecord& record = judge_of(check);
    if (record.columns != nullptr) return record.columns(text_of(names), components);
    if (record.free_rows) return {};
    const bool square = components == 9 || components == 16;
    if (&rows_of(check) != &matrix_rows() || !square) return column_names(text_of(names), components, check.value);
    std::vector<std::string> entries;
    for (std::size_t i = 0; i < components; ++i) entries.push_back("entry " + matrix_entry(components, i));
    return entries;
}

std::vector<double> row_of(const TensorView& view, std::size_t row)
{
    if (!view.present(row)) return {};
    const auto cell = view.cell(row);
    return {cell.begin(), cell.end()};
}

void add_rows(const AskedCheck& asked, const QuestionLog& log, const RunOutcome& run, const Expected& expected,
              AskedAnswers& answers)
{
    const Tensor& student = *observed(asked.check, run);
    const TensorView yours(student);
    const TensorView right(*expected.value);
    const std::vector<RowState> states = single_rows(asked.check, student, expected);
    answers.optional = right.optional();
    // What stands in a table where nothing was answered is no number of the student's, in whichever of the rows that
    // one question led to the refusal is written down.
    std::set<std::uint32_t> refused;
    for (const auto& [row, why] : refusals_in(run, asked.check.value))
        if (const auto question = log.question_of(asked.check.value, row, states.size())) refused.insert(*question);
    for (std::size_t row = 0; row < std::min(states.size(), most_answers); ++row) {
        const auto question = log.question_of(asked.check.value, row, states.size());
        if (states[row] == RowState::left_out || !question) continue;
        const bool is_refused = refused.contains(*question);
        answers.all.push_back({*question,
                               row,
                               {is_refused ? std::vector<double>() : row_of(yours, row), row_of(right, row),
                                states[row] == RowState::wrong, is_refused}});
    }
}

/// The rows of two tables that one question led to.
struct RowsOfQuestion {
    std::vector<std::size_t> yours{};
    std::vector<std::size_t> expected{};
};

using RowsOfQuestions = std::map<std::uint32_t, RowsOfQuestion>;

void add_rows_of(const QuestionLog& log, const std::string& value, std::size_t rows,
                 std::vector<std::size_t> RowsOfQuestion::*whose, RowsOfQuestions& found)
{
    for (std::size_t row = 0; row < rows; ++row)
        if (const auto question = log.question_of(value, row, rows)) (found[*question].*whose).push_back(row);
}

/// Questions to the same functions that led to no row of any table: nothing was to be found, and nothing was.
void add_without_rows(const QuestionLog& log, const QuestionLog& told, RowsOfQuestions& found)
{
    std::set<std::uint32_t> with_rows;
    for (const QuestionLog* const one : {&log, &told})
        for (const auto& [value, questions] : one->rows)
            for (const std::uint32_t question : questions)
                if (question > 0) with_rows.insert(question - 1);
    std::vector<std::uint32_t> without;
    for (const QuestionKind& kind : log.kinds) {
        const auto is_of_kind = [&](const auto& one) { return kind.questions.contains(one.first); };
        if (std::ranges::none_of(found, is_of_kind)) continue;
        for (const auto& [question, features] : kind.questions)
            if (!with_rows.contains(question)) without.push_back(question);
    }
    for (const std::uint32_t question : without) found.try_emplace(question);
}

bool is_right(const Check& check, const Tensor& yours, const Tensor& right, const Tensor* margin)
{
    if (yours.rows == 0 || right.rows == 0) return yours.rows == right.rows;
    if (!judge_of(check).free_rows && yours.rows != right.rows) return false;
    return judge(check, yours, right, margin).right >= 1;
}

/// "no row", "3 rows".
std::string number_of_rows(std::size_t rows)
{
    return rows == 0 ? "no row" : fmt::format("{} {}", rows, rows == 1 ? "row" : "rows");
}

/// What is wrong in the rows of one question.
WrongGroup wrong_group(const Check& check, std::uint32_t question, const RowsOfQuestion& rows, const Tensor& yours,
                       const Tensor& expected, const Expected& all, const Tensor* margin)
{
    if (!judge_of(check).free_rows && yours.rows != expected.rows)
        return {question, Difference{"this call", number_of_rows(yours.rows), number_of_rows(expected.rows)}};
    // Judges compare with something.
    if (expected.rows == 0) return {question};
    const Judgement judgement = judge(check, yours, expected, margin, all.names);
    if (!judgement.first_difference) return {question};
    Difference first = *judgement.first_difference;
    first.others.clear();
    // That a row stands elsewhere in its list does not mean that it is not there.
    if (const std::size_t keys = judge_of(check).keys; keys > 1)
        if (auto apart = first_value_apart(yours, expected, keys)) {
            const std::string came = apart->yours == "nothing" ? "nothing came" : apart->yours + " came instead";
            std::string words = apart->expected == "nothing"
                                    ? fmt::format("one call: {} came, and is not expected of this call", apart->yours)
                                    : fmt::format("one call: expected {}, {}", apart->expected, came);
            if (apart->cell) apart->cell = rows.expected.at(*apart->cell);
            const bool are_both = apart->yours != "nothing" && apart->expected != "nothing";
            if (auto whole = short_lists(yours, expected, keys)) {
                whole->cell = apart->cell;
                apart = std::move(whole);
            }
            return {question, std::move(apart), std::move(words), are_both};
        }
    const bool is_expected = first.cell && *first.cell < rows.expected.size();
    first.cell = is_expected ? std::optional(rows.expected[*first.cell]) : std::nullopt;
    const std::string where = is_expected ? fmt::format("row {}", *first.cell) : "one call";
    first.where = is_expected ? fmt::format("{} of {}", where, all.value->rows) : "this call";
    WrongGroup group{question, std::move(first)};
    const std::size_t begin = judgement.message.find(": ");
    const std::size_t counts = judgement.message.rfind(" (");
    if (begin != std::string::npos && counts != std::string::npos && begin < counts)
        group.words = where + judgement.message.substr(begin, counts - begin);
    group.as_first = !judgement.headline.empty();
    // Of the rows of one call it is known.
    constexpr std::string_view nowhere = "is expected nowhere";
    if (const std::size_t place = group.words.find(nowhere); place != std::string::npos)
        group.words.replace(place, nowhere.size(), "is not expected of this call");
    return group;
}

/// All rows of a question together. The student's run says itself which of its rows are whose: it runs again for that.
void add_groups(const AskedCheck& asked, const QuestionLog& log, const Expected& expected, std::uint64_t seed,
                AskedAnswers& answers)
{
    const std::string& value = asked.check.value;
    const RunOutcome& told = asked.runs.told(seed);
    const Tensor* student = observed(asked.check, told);
    if (told.verdict != Verdict::ok || student == nullptr || student->columns > 1 || expected.value->columns > 1)
        return;
    const Tensor& right = *expected.value;
    if (!well_formed(*student) || !well_formed(right) || row_shape_error(*student, right)) return;
    RowsOfQuestions all;
    add_rows_of(log, value, right.rows, &RowsOfQuestion::expected, all);
    const QuestionLog told_by_student = read_questions(told.recording.tensors);
    add_rows_of(told_by_student, value, student->rows, &RowsOfQuestion::yours, all);
    add_without_rows(log, told_by_student, all);
    Check check = asked.check;
    check.pairs = false;
    const bool has_margin = expected.margin != nullptr && expected.margin->rows == right.rows &&
                            expected.margin->columns == 1 && well_formed(*expected.margin);
    const std::map<std::size_t, std::string> refused = refusals_in(told, value);
    for (const auto& [question, rows] : all) {
        if (answers.all.size() == most_answers) break;
        const Tensor one = student->rows == 0 ? some_rows(right, {}) : some_rows(*student, rows.yours);
        const Tensor other = some_rows(right, rows.expected);
        const Tensor margin = has_margin ? some_rows(*expected.margin, rows.expected) : Tensor();
        const Tensor* const of_rows = has_margin ? &margin : nullptr;
        const bool is_refused = std::ranges::any_of(rows.yours, [&](std::size_t row) { return refused.contains(row); });
        const bool wrong = !is_right(check, one, other, of_rows);
        if (wrong && !answers.first_wrong)
            answers.first_wrong = wrong_group(check, question, rows, one, other, expected, of_rows);
        answers.all.push_back(
            {question,
             std::nullopt,
             {is_refused ? std::vector<double>() : to_doubles(one), to_doubles(other), wrong, is_refused}});
    }
    answers.optional = true;
}

/// How often each function was called.
class CallCounts {
public:
    /// Of a kind that is not known, nothing.
    void add(const QuestionKind* kind)
    {
        if (kind != nullptr) ++count_[kind->function];
    }
    [[nodiscard]] std::string most() const
    {
        const auto most = std::ranges::max_element(count_, {}, [](const auto& one) { return one.second; });
        return most == count_.end() ? std::string() : most->first;
    }

private:
    std::map<std::string, std::size_t> count_;
};

}

const QuestionLog& questions_at(Worker& worker, const AskedCheck& asked, std::uint64_t seed)
{
    return seed == asked.result.seed ? asked.log : worker.questions(asked.exercise, asked.check.case_name, seed);
}

AskedAnswers asked_answers(Worker& worker, const AskedCheck& asked, std::uint64_t seed)
{
    const Check& check = asked.check;
    AskedAnswers answers;
    const bool seen = seed == asked.result.seed;
    // What was graded of a hidden case is not asked again.
    if ((asked.result.hidden && seen) || check.relation || !judge_of(check).plain_values) return answers;
    const RunOutcome& run = worker.trusted(asked.exercise, judged_against(check), check.case_name, seed);
    const QuestionLog& log = questions_at(worker, asked, seed);
    const Expected expected = expected_of(check, run);
    if (expected.value == nullptr) return answers;
    answers.components = expected.value->components;
    answers.keys = judge_of(check).keys;
    answers.columns = names_of_columns(check, expected.names, answers.components);
    answers.picture = is_picture(check);
    if (const auto kinds = judge_of(check).kinds) answers.kinds = kinds(text_of(expected.names), answers.components);
    const RunOutcome& student = asked.runs.plain(seed);
    if (student.verdict != Verdict::ok) return answers;
    const Tensor* yours = observed(check, student);
    if (has_single_rows(check, yours, expected.value))
        add_rows(asked, log, student, expected, answers);
    else
        add_groups(asked, log, expected, seed, answers);
    return answers;
}

std::string function_asked_most(const AskedAnswers& answers, const QuestionLog& log)
{
    CallCounts calls;
    for (const AskedAnswer& one : answers.all)
        if (one.answer.wrong) calls.add(log.kind_of(one.question));
    return calls.most();
}

std::string function_asked_most(const QuestionLog& log, const std::string& value)
{
    CallCounts calls;
    if (const auto rows = log.rows.find(value); rows != log.rows.end())
        for (const std::uint32_t question : rows->second)
            if (question > 0) calls.add(log.kind_of(question - 1));
    const std::string most = calls.most();
    return most.empty() && log.kinds.size() == 1 ? log.kinds.front().function : most;
}

std::optional<WrongGroup> first_wrong_group(Worker& worker, const AskedCheck& asked, std::uint64_t seed)
{
    return asked_answers(worker, asked, seed).first_wrong;
}

}
