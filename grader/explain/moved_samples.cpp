#include "explain/moved_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "explain/other_answers.hpp"
#include "explain/samples.hpp"
#include "judge/judges.hpp"
#include "question/movable.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_moved = 64;
constexpr std::size_t most_moved_cells = 20'000;  ///< of a table
constexpr double most_seconds_of_runs = 1;        ///< of the reference's

/// What is to be moved: the function's own arguments, and those of the functions that made or changed its objects.
std::vector<OtherQuestion> moves_of(const QuestionLog& log, const std::string& function)
{
    std::vector<OtherQuestion> moves = movable(log, function);
    const auto history = log.histories.find(function);
    if (history == log.histories.end()) return moves;
    for (const std::string& before : history->second)
        if (before != function) std::ranges::copy(movable(log, before), std::back_inserter(moves));
    return moves;
}

/// The numbers of a table as large as `like`; NaN where there is none.
std::vector<double> numbers_of(const Tensor* tensor, const Tensor& like)
{
    if (tensor == nullptr || tensor->cells() != like.cells() || tensor->components != like.components ||
        !well_formed(*tensor))
        return std::vector<double>(like.cells() * like.components, std::nan(""));
    return numbers_or_nan(*tensor);
}

/// Adds one table's rows to those of another, which then hold `size` numbers; what was not asked leaves none.
void append(std::vector<double>& all, const std::vector<double>& more, std::size_t size)
{
    all.insert(all.end(), more.begin(), more.end());
    all.resize(size, std::nan(""));
}

/// How many numbers each question led to, one a row; 1 where it is not the same number for all, or too many to name.
std::size_t rows_of_each(const AskedAnswers& answers, std::size_t rows)
{
    constexpr std::size_t most_rows = 4;
    if (answers.components != 1 || answers.all.size() != rows) return 1;
    const auto is_other = [&](const AskedAnswer& one) { return one.question != answers.all.front().question; };
    const auto second = std::ranges::find_if(answers.all, is_other);
    const auto each = static_cast<std::size_t>(second - answers.all.begin());
    if (each > most_rows || rows % each != 0) return 1;
    for (std::size_t i = 0; i < rows; ++i) {
        const AskedAnswer& one = answers.all[i];
        const bool is_first = i % each == 0;
        const bool is_as_before = i > 0 && one.question == answers.all[i - 1].question;
        if (one.row != i || is_first == is_as_before) return 1;
    }
    return each;
}

}

std::optional<double> GivenNumbers::at(const MovedPlace& place) const
{
    const auto found = std::ranges::find(kind->features, place.place);
    if (found == kind->features.end() || place.function != kind->function || place.is_length) return std::nullopt;
    return kind->questions.at(question).at(static_cast<std::size_t>(found - kind->features.begin()));
}

void MovedSamples::add(const AskedCheck& asked, std::uint64_t seed)
{
    const Check& check = asked.check;
    AskedAnswers answers = asked_answers(worker_, asked, seed);
    const QuestionLog& log = worker_.questions(asked.exercise, check.case_name, seed);
    if (function_.empty()) function_ = function_asked_most(answers, log);
    const RunOutcome& expected = worker_.trusted(asked.exercise, judged_against(check), check.case_name, seed);
    const Tensor* const right = tensor_of(expected, check.value);
    const Tensor* const yours = observed(check, asked.runs.plain(seed));
    // A shader has no such name; to draw as often takes too long.
    const bool is_called = function_.find("::") != std::string::npos;
    if (!is_called || (asked.exercise.gl && leaves_picture(expected)) || answers.picture || right == nullptr ||
        !well_formed(*right) || !has_single_rows(check, yours, right) ||
        right->cells() * right->components > most_moved_cells)
        return;
    if (!table_.all.moved.empty() && answers.components != table_.all.components) return;
    std::vector<OtherAnswers> others;
    for (OtherQuestion& move : moves_of(log, function_))
        if (others.size() < most_moved) others.push_back({std::move(move)});
    if (others.empty()) return;
    if (seconds_of_other(expected, log) * static_cast<double>(others.size()) > most_seconds_of_runs) return;
    ask_both(worker_, asked, seed, others, time_);
    std::vector<MovedAnswers> moved;
    for (OtherAnswers& one : others)
        moved.push_back({std::move(one.question), numbers_of(tensor_of(one.yours, check.value), *right),
                         numbers_of(tensor_of(one.right, check.value), *right)});
    add_rows(answers, log, *right, yours, std::move(moved));
    const std::size_t each = rows_of_each(answers, right->cells());
    rows_of_each_ = rows_of_each_.value_or(each) == each ? each : 1;
    if (table_.named.all.empty()) table_.named = std::move(answers);
}

void MovedSamples::add_rows(const AskedAnswers& answers, const QuestionLog& log, const Tensor& right,
                            const Tensor* yours, std::vector<MovedAnswers> moved)
{
    table_.all.components = answers.components;
    const std::size_t first_row = table_.all.right.size() / table_.all.components;
    for (const AskedAnswer& answer : answers.all) {
        const QuestionKind* const kind = answer.answer.wrong && answer.row ? log.kind_of(answer.question) : nullptr;
        if (kind == nullptr || kind->function != function_) continue;
        table_.all.wrong.push_back(first_row + *answer.row);
        table_.given.push_back({kind, answer.question});
    }
    table_.all.ends.push_back(table_.all.wrong.size());
    const std::size_t size = table_.all.right.size() + right.cells() * right.components;
    append(table_.all.right, numbers_of(&right, right), size);
    append(table_.all.yours, numbers_of(yours, right), size);
    if (table_.all.moved.empty())
        for (const MovedAnswers& each : moved) table_.all.moved.push_back({each.move});
    for (MovedAnswers& each : table_.all.moved) {
        const auto now = std::ranges::find(moved, each.move, &MovedAnswers::move);
        append(each.yours, now == moved.end() ? std::vector<double>() : now->yours, size);
        append(each.right, now == moved.end() ? std::vector<double>() : now->right, size);
    }
}

std::optional<MovedTable> MovedSamples::by_questions() const
{
    const std::size_t each = rows_of_each_.value_or(1);
    if (each == 1) return std::nullopt;
    MovedTable joined = table_;
    joined.all.components = joined.named.components = each;
    joined.named.columns.clear();
    for (std::size_t i = 1; i <= each; ++i) joined.named.columns.push_back(fmt::format("number {} of {}", i, each));
    joined.all.wrong.clear();
    joined.all.ends.clear();
    joined.given.clear();
    for (std::size_t i = 0; i <= table_.all.wrong.size(); ++i) {
        if (std::ranges::find(table_.all.ends, i) != table_.all.ends.end())
            joined.all.ends.push_back(joined.given.size());
        if (i == table_.all.wrong.size()) break;
        const std::size_t row = table_.all.wrong[i] / each;
        if (!joined.all.wrong.empty() && joined.all.wrong.back() == row) continue;
        joined.all.wrong.push_back(row);
        joined.given.push_back(table_.given[i]);
    }
    return joined;
}

}
