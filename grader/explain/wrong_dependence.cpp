#include "explain/wrong_dependence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "explain/other_answers.hpp"
#include "explain/question_words.hpp"
#include "explain/samples.hpp"
#include "judge/judges.hpp"
#include "question/dependence.hpp"
#include "question/error_dependence.hpp"
#include "question/movable.hpp"
#include "question/names.hpp"

#include <umbral/record/reflect.hpp>

namespace umbral::grader {
namespace {

constexpr std::size_t most_moved = 64;
constexpr std::size_t most_moved_cells = 20'000;  ///< of a table
constexpr double most_seconds_of_runs = 1;        ///< of the reference's
constexpr std::size_t fresh_place = 11;  ///< of practice inputs, behind those that conditions are confirmed on; two
constexpr std::size_t enough_moved = 8;  ///< answers; of fewer, other cases are asked too
constexpr std::size_t least_moved = 4;   ///< answers; of fewer it may come of their inputs, as a ray along an axis
constexpr std::size_t most_told = 2;     ///< kinds of dependence
constexpr std::size_t most_named = 3;    ///< numbers of an answer

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

/// The numbers that a question led to, one a row, as the numbers of one row, where all questions led to as many: each
/// may depend on other things.
AskedAnswers in_rows_of_questions(AskedAnswers answers, std::size_t rows)
{
    const std::size_t each = rows_of_each(answers, rows);
    if (each == 1) return answers;
    std::vector<AskedAnswer> joined;
    for (AskedAnswer& one : answers.all) {
        if (*one.row % each == 0) {
            joined.push_back(std::move(one));
            joined.back().row = *joined.back().row / each;
        } else {
            joined.back().answer.wrong = joined.back().answer.wrong || one.answer.wrong;
        }
    }
    answers.all = std::move(joined);
    answers.components = each;
    answers.columns.clear();
    for (std::size_t i = 1; i <= each; ++i) answers.columns.push_back(fmt::format("number {} of {}", i, each));
    return answers;
}

/// Answers of a check with the inputs of several seeds, and of other checks of the same function.
class Asked {
public:
    Asked(Worker& worker, SpareTime& time) : worker_(worker), time_(time) {}

    /// Asks with the inputs of a seed, and adds the answers behind those that are there.
    void add(const AskedCheck& asked, std::uint64_t seed)
    {
        const Check& check = asked.check;
        AskedAnswers as_judged = asked_answers(worker_, asked, seed);
        const QuestionLog& log = worker_.questions(asked.exercise, check.case_name, seed);
        if (function.empty()) function = function_asked_most(as_judged, log);
        const RunOutcome& expected = worker_.trusted(asked.exercise, judged_against(check), check.case_name, seed);
        const Tensor* const right = tensor_of(expected, check.value);
        const Tensor* const yours = observed(check, asked.runs.plain(seed));
        // A shader has no such name; to draw as often takes too long.
        const bool is_called = function.find("::") != std::string::npos;
        if (!is_called || (asked.exercise.gl && leaves_picture(expected)) || as_judged.picture || right == nullptr ||
            !well_formed(*right) || !has_single_rows(check, yours, right) ||
            right->cells() * right->components > most_moved_cells)
            return;
        AskedAnswers answers = in_rows_of_questions(std::move(as_judged), right->cells());
        if (!all.moved.empty() && answers.components != all.components) return;
        std::vector<OtherAnswers> others;
        for (OtherQuestion& move : moves_of(log, function))
            if (others.size() < most_moved) others.push_back({std::move(move)});
        if (others.empty()) return;
        if (expected.cpu_seconds * static_cast<double>(others.size()) > most_seconds_of_runs) return;
        ask_both(worker_, asked, seed, others, time_);
        std::vector<MovedAnswers> moved;
        for (OtherAnswers& one : others)
            moved.push_back({std::move(one.question), numbers_of(tensor_of(one.yours, check.value), *right),
                             numbers_of(tensor_of(one.right, check.value), *right)});
        add_rows(answers, log, *right, yours, std::move(moved));
        if (named.all.empty()) named = std::move(answers);
    }

    std::string function;  ///< that is asked, once that is known
    AskedAnswers named;    ///< the first that were added
    AnswersToMoves all;

private:
    void add_rows(const AskedAnswers& answers, const QuestionLog& log, const Tensor& right, const Tensor* yours,
                  std::vector<MovedAnswers> moved)
    {
        all.components = answers.components;
        const std::size_t first_row = all.right.size() / all.components;
        for (const AskedAnswer& answer : answers.all) {
            const QuestionKind* const kind = answer.answer.wrong && answer.row ? log.kind_of(answer.question) : nullptr;
            if (kind != nullptr && kind->function == function) all.wrong.push_back(first_row + *answer.row);
        }
        all.ends.push_back(all.wrong.size());
        const std::size_t size = all.right.size() + right.cells() * right.components;
        append(all.right, numbers_of(&right, right), size);
        append(all.yours, numbers_of(yours, right), size);
        if (all.moved.empty())
            for (const MovedAnswers& each : moved) all.moved.push_back({each.move});
        for (MovedAnswers& each : all.moved) {
            const auto now = std::ranges::find(moved, each.move, &MovedAnswers::move);
            append(each.yours, now == moved.end() ? std::vector<double>() : now->yours, size);
            append(each.right, now == moved.end() ? std::vector<double>() : now->right, size);
        }
    }

    Worker& worker_;
    SpareTime& time_;
};

/// Writes what answers depend on in the words of the unit's headers.
class Words {
public:
    Words(const std::string& headers, std::string function) : headers_(headers), function_(std::move(function)) {}

    [[nodiscard]] std::string sentence(const Dependence& one, const AskedAnswers& answers) const
    {
        std::string text;
        if (one.lacking.empty())
            text = fmt::format("your wrong answers change with {}, and the right ones do not", words(one.wrongly));
        else if (one.wrongly.empty())
            text = fmt::format("your wrong answers do not change with {}, and the right ones do", words(one.lacking));
        else
            text = fmt::format("your wrong answers change with {}, and the right ones with {} instead",
                               words(one.wrongly), words(one.lacking));
        return in_numbers(one.components, answers) + text;
    }

    [[nodiscard]] std::string sentence(const ErrorDependence& one, const AskedAnswers& answers) const
    {
        return fmt::format("{}{} depends on {} alone", in_numbers(one.components, answers),
                           one.kind == ErrorKind::factor ? "how many times the right one your wrong answer is"
                                                         : "the difference of your wrong answer to the right one",
                           word(one.place));
    }

private:
    /// "in x, y "; empty where it is all numbers of an answer.
    [[nodiscard]] static std::string in_numbers(const std::vector<std::size_t>& components,
                                                const AskedAnswers& answers)
    {
        if (components.size() == answers.components) return "";
        std::vector<std::string> names;
        for (const std::size_t i : components)
            if (i < answers.columns.size()) names.push_back(answers.columns[i]);
        return fmt::format("in {} ", fmt::join(names, ", "));
    }

    [[nodiscard]] std::string word(const MovedPlace& one) const
    {
        std::string text = (one.is_length    ? "the length of "
                            : one.is_order   ? "the order of "
                            : one.is_corners ? "which corner comes first in each of "
                                             : "") +
                           in_words(one.place, parameter_names(headers_, one.function));
        if (one.function != function_) text += " of " + std::string(reflect::last_name(one.function));
        return text;
    }

    [[nodiscard]] std::string words(const std::vector<MovedPlace>& places) const
    {
        std::vector<std::string> all;
        for (const MovedPlace& place : places) all.push_back(word(place));
        return listed(all);
    }

    const std::string& headers_;
    std::string function_;
};

/// May it be said of these numbers? Those without a name of their own are told of only if it is all of them.
bool can_be_named(const std::vector<std::size_t>& components, const AskedAnswers& answers)
{
    if (components.size() == answers.components) return true;
    return components.size() <= most_named &&
           std::ranges::all_of(components, [&](std::size_t i) { return i < answers.columns.size(); });
}

/// Of numbers of which nothing else is told, the first.
std::optional<ErrorDependence> error_to_tell(const Asked& answers, const std::vector<Dependence>& told)
{
    for (ErrorDependence& one : error_dependences(answers.all)) {
        const auto is_told = [&](const Dependence& other) {
            return std::ranges::find_first_of(one.components, other.components) != one.components.end();
        };
        if (std::ranges::none_of(told, is_told) && can_be_named(one.components, answers.named)) return std::move(one);
    }
    return std::nullopt;
}

}

std::string wrong_dependence(Worker& worker, const AskedCheck& asked, SpareTime& time)
{
    if (!time.is_left() || asked.check.relation || !judge_of(asked.check).plain_values) return "";
    Asked answers(worker, time);
    answers.add(asked, input_seed(asked, 0));
    answers.add(asked, varied_seed(asked, fresh_place));
    if (!asked.exercise.gl) answers.add(asked, varied_seed(asked, fresh_place + 1));
    if (answers.all.moved.empty()) return "";
    const auto is_enough = [&] { return answers.all.wrong.size() >= enough_moved || !time.is_left(); };
    if (asked.others)
        asked.others([&](const AskedCheck& other) {
            if (!is_enough()) answers.add(other, input_seed(other, 0));
            return !is_enough();
        });
    if (answers.all.wrong.size() < least_moved) return "";
    std::vector<Dependence> found = dependences(answers.all);
    std::erase_if(found, [&](const Dependence& one) { return !can_be_named(one.components, answers.named); });
    // What a number depends on instead says more than that it depends on something.
    std::ranges::stable_sort(found, {},
                             [](const Dependence& one) { return one.wrongly.empty() || one.lacking.empty(); });
    if (found.size() > most_told) found.resize(most_told);
    const Words words(asked.headers, answers.function);
    std::string text;
    const auto add = [&](const std::string& sentence) { text += (text.empty() ? "" : "; ") + sentence; };
    for (const Dependence& one : found) add(words.sentence(one, answers.named));
    if (const auto error = error_to_tell(answers, found)) add(words.sentence(*error, answers.named));
    return text;
}

}
