#include "explain/wrong_dependence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <umbral/record/variation.hpp>

#include "explain/samples.hpp"
#include "explain/weighed_questions.hpp"
#include "judge/judges.hpp"
#include "question/dependence.hpp"
#include "question/movable.hpp"
#include "question/names.hpp"

#include <umbral/record/questions.hpp>
#include <umbral/record/reflect.hpp>

namespace umbral::grader {
namespace {

constexpr std::size_t most_moved = 64;
constexpr std::size_t most_moved_cells = 20'000;  ///< of a table
constexpr double most_seconds_of_runs = 1;        ///< of the reference's
constexpr std::size_t fresh_place = 11;           ///< of practice inputs, behind those that conditions are confirmed on
constexpr std::size_t enough_moved = 8;           ///< answers; of fewer, other cases are asked too
constexpr std::size_t most_told = 2;              ///< kinds of dependence
constexpr std::size_t most_named = 3;             ///< numbers of an answer

/// The function that most wrong answers were asked of.
std::string function_asked_most(const AskedAnswers& answers, const QuestionLog& log)
{
    std::map<std::string, std::size_t> count;
    for (const AskedAnswer& one : answers.all)
        if (const QuestionKind* const kind = one.answer.wrong ? log.kind_of(one.question) : nullptr)
            ++count[kind->function];
    const auto most = std::ranges::max_element(count, {}, [](const auto& one) { return one.second; });
    return most == count.end() ? std::string() : most->first;
}

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
    std::vector<double> numbers(like.cells() * like.components, std::nan(""));
    if (tensor == nullptr || tensor->cells() != like.cells() || tensor->components != like.components ||
        !well_formed(*tensor))
        return numbers;
    const TensorView view(*tensor);
    for (std::size_t row = 0; row < like.cells(); ++row)
        if (view.present(row))
            std::ranges::copy(view.cell(row), numbers.begin() + static_cast<std::ptrdiff_t>(row * like.components));
    return numbers;
}

/// The inputs of one seed.
struct MovedCase {
    Worker& worker;
    const AskedCheck& asked;
    std::uint64_t seed;
    const Tensor& like;  ///< the right answers
    SpareTime& time;
};

/// Asks both with these moves. Where one of them does not come to its end, each half by itself; a move that it fails
/// with leaves no numbers.
void ask_moved(const MovedCase& one, std::span<MovedAnswers> moved)
{
    const auto& [worker, asked, seed, like, time] = one;
    if (moved.empty() || !time.is_left()) return;
    const double before = worker.run_seconds();
    Inquiry inquiry;
    for (const MovedAnswers& each : moved) inquiry.others.push_back(each.move);
    const std::string& case_name = asked.check.case_name;
    const RunOutcome right = worker.inquire(asked.exercise, judged_against(asked.check), case_name, seed, inquiry);
    const RunOutcome yours =
        worker.run_moved(asked.exercise, asked.runs.built(), case_name, seed, inquiry.others, asked.check.value);
    time.spend(worker.run_seconds() - before);
    if (right.verdict != Verdict::ok || yours.verdict != Verdict::ok) {
        if (moved.size() == 1) return;
        ask_moved(one, moved.first(moved.size() / 2));
        ask_moved(one, moved.subspan(moved.size() / 2));
        return;
    }
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const std::string name = std::to_string(i) + question_names::of_other + asked.check.value;
        moved[i].right = numbers_of(tensor_of(right, name), like);
        moved[i].yours = numbers_of(tensor_of(yours, name), like);
    }
}

/// Adds one table's rows to those of another; a move that was not asked leaves none.
void append(std::vector<double>& all, const std::vector<double>& more, std::size_t size)
{
    all.insert(all.end(), more.begin(), more.end());
    all.resize(size, std::nan(""));
}

/// The answers with the inputs of a seed, behind those that are there.
void add_answers(Worker& worker, const AskedCheck& asked, std::uint64_t seed, std::string& function,
                 AskedAnswers& named, AnswersToMoves& all, SpareTime& time)
{
    const Check& check = asked.check;
    AskedAnswers answers = asked_answers(worker, asked, seed);
    const QuestionLog& log = worker.questions(asked.exercise, check.case_name, seed);
    if (function.empty()) function = function_asked_most(answers, log);
    const RunOutcome& expected = worker.trusted(asked.exercise, judged_against(check), check.case_name, seed);
    const Tensor* const right = tensor_of(expected, check.value);
    const Tensor* const yours = observed(check, asked.runs.plain(seed));
    if (function.empty() || answers.picture || (!all.moved.empty() && answers.components != all.components) ||
        right == nullptr || !well_formed(*right) || !has_single_rows(check, yours, right) ||
        right->cells() * right->components > most_moved_cells)
        return;
    std::vector<OtherQuestion> moves = moves_of(log, function);
    moves.resize(std::min(moves.size(), most_moved));
    if (expected.cpu_seconds * static_cast<double>(moves.size()) > most_seconds_of_runs) return;
    std::vector<MovedAnswers> moved;
    for (OtherQuestion& move : moves) moved.push_back({std::move(move)});
    const std::size_t at_a_time = questions_of_a_run(asked.exercise, expected);
    const MovedCase one{worker, asked, seed, *right, time};
    for (std::size_t i = 0; i < moved.size(); i += at_a_time)
        ask_moved(one, std::span(moved).subspan(i, std::min(at_a_time, moved.size() - i)));
    all.components = right->components;
    const std::size_t first_row = all.right.size() / all.components;
    for (const AskedAnswer& answer : answers.all) {
        const QuestionKind* const kind = answer.answer.wrong && answer.row ? log.kind_of(answer.question) : nullptr;
        if (kind != nullptr && kind->function == function) all.wrong.push_back(first_row + *answer.row);
    }
    const std::size_t size = all.right.size() + right->cells() * right->components;
    append(all.right, numbers_of(right, *right), size);
    append(all.yours, numbers_of(yours, *right), size);
    if (all.moved.empty()) {
        all.moved = std::move(moved);
        for (MovedAnswers& each : all.moved) {
            append(each.yours, {}, size);
            append(each.right, {}, size);
        }
    } else {
        for (MovedAnswers& each : all.moved) {
            const auto again = std::ranges::find(moved, each.move, &MovedAnswers::move);
            append(each.yours, again == moved.end() ? std::vector<double>() : again->yours, size);
            append(each.right, again == moved.end() ? std::vector<double>() : again->right, size);
        }
    }
    if (named.all.empty()) named = std::move(answers);
}

/// Writes what answers depend on in the words of the unit's headers.
class Words {
public:
    Words(const std::string& headers, std::string function) : headers_(headers), function_(std::move(function)) {}

    [[nodiscard]] std::string sentence(const Dependence& one, const AskedAnswers& answers) const
    {
        std::string text;
        if (one.lacking.empty())
            text = fmt::format("your answers change with {}, and the right ones do not", listed(one.wrongly));
        else if (one.wrongly.empty())
            text = fmt::format("your answers do not change with {}, and the right ones do", listed(one.lacking));
        else
            text = fmt::format("your answers change with {}, and the right ones with {} instead", listed(one.wrongly),
                               listed(one.lacking));
        std::vector<std::string> names;
        for (const std::size_t i : one.components)
            if (i < answers.columns.size()) names.push_back(answers.columns[i]);
        const bool is_all = one.components.size() == answers.components;
        if (!is_all) text.insert(0, fmt::format("in {} ", fmt::join(names, ", ")));
        return text + fmt::format(" ({} wrong answers, other inputs among them)", one.answers);
    }

private:
    [[nodiscard]] std::string word(const MovedPlace& one) const
    {
        std::string text =
            (one.is_length ? "the length of " : "") + in_words(one.place, parameter_names(headers_, one.function));
        if (one.function != function_) text += " of " + std::string(reflect::last_name(one.function));
        return text;
    }

    /// "box.left, box.right and the length of axis"
    [[nodiscard]] std::string listed(const std::vector<MovedPlace>& places) const
    {
        std::string text;
        for (std::size_t i = 0; i < places.size(); ++i)
            text += (i == 0 ? "" : i + 1 == places.size() ? " and " : ", ") + word(places[i]);
        return text;
    }

    const std::string& headers_;
    std::string function_;
};

/// May it be said of these numbers? Those without a name of their own are told of only if it is all of them.
bool can_be_named(const Dependence& one, const AskedAnswers& answers)
{
    if (one.components.size() == answers.components) return true;
    return one.components.size() <= most_named &&
           std::ranges::all_of(one.components, [&](std::size_t i) { return i < answers.columns.size(); });
}

}

std::string wrong_dependence(Worker& worker, const AskedCheck& asked, SpareTime& time)
{
    if (!time.is_left() || asked.check.relation || !judge_of(asked.check).plain_values) return "";
    AnswersToMoves all;
    AskedAnswers named;
    std::string function;
    const auto add = [&](const AskedCheck& one, std::uint64_t seed) {
        add_answers(worker, one, seed, function, named, all, time);
    };
    add(asked, input_seed(asked, 0));
    add(asked, VariedSeed::with_mark(input_seed(asked, fresh_place)));
    if (all.moved.empty()) return "";
    if (asked.others)
        asked.others([&](const AskedCheck& other) {
            if (all.wrong.size() < enough_moved) add(other, input_seed(other, 0));
            return all.wrong.size() < enough_moved && time.is_left();
        });
    std::vector<Dependence> found = dependences(all);
    std::erase_if(found, [&](const Dependence& one) { return !can_be_named(one, named); });
    // What a number depends on instead says more than that it depends on something.
    std::ranges::stable_sort(found, {},
                             [](const Dependence& one) { return one.wrongly.empty() || one.lacking.empty(); });
    if (found.size() > most_told) found.resize(most_told);
    const Words words(asked.headers, function);
    std::string text;
    for (const Dependence& one : found) text += (text.empty() ? "" : "; ") + words.sentence(one, named);
    return text;
}

}
