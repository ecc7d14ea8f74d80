#include "explain/questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "explain/answer_lengths.hpp"
#include "explain/asked_alone.hpp"
#include "explain/asked_answers.hpp"
#include "explain/changed_alike.hpp"
#include "explain/code_place.hpp"
#include "explain/common_condition.hpp"
#include "explain/other_cases.hpp"
#include "explain/other_questions.hpp"
#include "explain/practice_example.hpp"
#include "explain/question_code.hpp"
#include "explain/right_with.hpp"
#include "explain/rows_alone.hpp"
#include "explain/simplest_question.hpp"
#include "explain/wrong_dependence.hpp"
#include "explain/wrong_function.hpp"
#include "judge/judges.hpp"
#include "question/log.hpp"
#include "report/failing_order.hpp"
#include "worker/interface_text.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {
namespace {

/// What wrong answers share is looked for in all checks of a unit together for so long: it is said of one or two.
constexpr double most_pattern_seconds = 6;
/// … and what they depend on, until that is known of one.
constexpr double most_dependence_seconds = 4;

bool fails(const Check& check, const CheckResult& result) { return result.score < check.points; }

/// The rows that a page shows of a check.
std::vector<RowPair*> rows_in(html::UnitDetail* detail, const std::string& check)
{
    std::vector<RowPair*> rows;
    if (detail == nullptr) return rows;
    if (auto* evidence = std::get_if<RowsEvidence>(&detail->checks[check].evidence)) {
        for (RowPair& row : evidence->first) rows.push_back(&row);
        for (RowPair& row : evidence->worst) rows.push_back(&row);
    }
    return rows;
}

/// A place in a report where the questions behind a value are shown.
struct Shown {
    QuestionSpan questions;
    std::string* code;
};

/// A row with a wrong answer, and what was asked there.
struct WrongRow {
    std::uint32_t question;
    std::size_t row;
};

/// One more sentence, if there is one.
void add_part(std::string& text, const std::string& part)
{
    if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
}

/// Puts the words of a call before the counts in a message, and leaves those alone where the two values are shown
/// anyway.
void say_first(const WrongGroup& group, CheckResult& result)
{
    const std::size_t counts = result.message.rfind(" (");
    if (counts == std::string::npos) return;
    result.headline.clear();
    if (group.as_first && result.message.ends_with(')'))
        result.headline = result.message.substr(counts + 2, result.message.size() - counts - 3);
    result.message = group.words + result.message.substr(counts);
}

class CaseQuestions {
public:
    CaseQuestions(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                  const std::string& case_name)
        : worker_(worker),
          exercise_(exercise),
          built_(built),
          cases_(cases),
          one_(cases.at(case_name)),
          case_(case_name),
          log_(worker.questions(exercise, case_, one_.seed)),
          runs_(worker, exercise, built, case_, one_)
    {
    }

    [[nodiscard]] bool known() const { return !log_.rows.empty() || !log_.wholes.empty(); }

    void add(const Check& check, CheckResult& result, html::UnitDetail* detail, const std::string& headers,
             SpareTime& patterns, SpareTime& dependence)
    {
        const RunOutcome& run = worker_.trusted(exercise_, judged_against(check), case_, one_.seed);
        const Tensor* expected = tensor_of(run, check.value);
        if (expected == nullptr) return;
        const auto show = [&](std::size_t cell, std::string& code) {
            if (const QuestionSpan asked = log_.questions_of(check.value, cell, expected->cells()); asked.count > 0)
                shown_.push_back({asked, &code});
        };
        if (result.first_difference && is_of_several(check, expected->cells(), *result.first_difference))
            result.first_difference->cell.reset();
        std::optional<WrongRow> wrong;
        if (result.first_difference && result.first_difference->cell) {
            const std::size_t cell = *result.first_difference->cell;
            show(cell, result.first_difference->question);
            const QuestionSpan asked = log_.questions_of(check.value, cell, expected->cells());
            if (const auto [place, rows] = log_.place_of_row(check.value, cell); rows > 1)
                result.first_difference->where += fmt::format(", number {} of {} from this call", place + 1, rows);
            // No debugger can stop at several.
            if (asked.count > 1) result.first_difference->cell.reset();
            // Where rows are free, the first that lacks need not be of a question with a wrong answer.
            if (asked.count == 1 && !judge_of(check).free_rows) wrong = {asked.first, cell};
        }
        for (RowPair* row : rows_in(detail, check.name)) show(row->cell, row->question);
        if (result.beside || !may_repeat(worker_, exercise_, one_)) return;
        AskedCheck asked{exercise_, check, runs_, one_, log_, headers};
        asked.others = [&](const auto& look) { look_elsewhere(check, headers, look); };
        if (auto group = first_wrong_group(worker_, asked, one_.seed)) {
            wrong = {group->question, group->first ? group->first->cell.value_or(0) : 0};
            if (!group->words.empty() && judge_of(check).free_rows) say_first(*group, result);
            const bool is_better = group->first || (result.first_difference && !result.first_difference->cell);
            if (group->first) result.first_difference = std::move(group->first);
            if (is_better) shown_.push_back({{group->question, 1}, &result.first_difference->question});
        }
        if (one_.hidden)
            if (auto example = practice_example(worker_, asked)) {
                result.practice_example = std::move(example->first);
                result.practice_seed = example->seed;
            }
        const bool alone = wrong && !check.hidden &&
                           is_right_alone(worker_, exercise_, built_, check, one_, wrong->question, wrong->row);
        // What wrong answers share says nothing of the cause then.
        AnswerPattern shared =
            alone ? AnswerPattern{right_alone_of(exercise_)} : sentence_of(find_in_common(worker_, asked, patterns));
        if (shared.words.empty()) shared.words = rows_alone(worker_, asked, patterns);
        if (!alone) {
            // Where each row has its partner, how many there are in which call says no more.
            const std::string changed = changed_alike(worker_, asked, patterns);
            add_part(shared.words, changed.empty() ? answer_lengths(worker_, asked, patterns) : changed);
            std::string function = wrong_function(worker_, asked, patterns);
            add_part(function, shared.words);
            shared.words = std::move(function);
        }
        result.told_by_question = shared.of_question;
        (one_.hidden ? result.practice : result.common) = std::move(shared.words);
        if (!one_.hidden) result.common_tells = shared.tells;
        if (!alone) {
            result.depends = wrong_dependence(worker_, asked, dependence);
            add_part(result.depends, right_with(changes_that_make_right(worker_, asked, dependence), headers));
        }
    }

    /// Asks for the code of all that is shown.
    void write()
    {
        std::set<std::uint32_t> wanted;
        for (const Shown& one : shown_)
            for (const std::uint32_t question : shown_of(one.questions)) wanted.insert(question);
        if (wanted.empty()) return;
        const std::map<std::uint32_t, std::string> code =
            worker_.code_of(exercise_, case_, one_.seed, {wanted.begin(), wanted.end()});
        for (const Shown& one : shown_) *one.code = together(one.questions, code);
    }

private:
    /// Rows that one value may belong to, and that are answers to different questions: nobody knows which it is.
    [[nodiscard]] bool is_of_several(const Check& check, std::size_t cells, const Difference& first) const
    {
        return std::ranges::any_of(first.others, [&](std::size_t other) {
            return log_.questions_of(check.value, other, cells) != log_.questions_of(check.value, *first.cell, cells);
        });
    }

    /// AskedCheck::others.
    void look_elsewhere(const Check& check, const std::string& headers,
                        const std::function<bool(const AskedCheck&)>& look) const
    {
        for (const Check* const other : checks_beside(exercise_, cases_, check)) {
            const CaseResult& one = cases_.at(other->case_name);
            CaseRuns runs(worker_, exercise_, built_, other->case_name, one);
            const QuestionLog& log = worker_.questions(exercise_, other->case_name, one.seed);
            if (!look({exercise_, *other, runs, one, log, headers})) return;
        }
    }

    Worker& worker_;
    const Exercise& exercise_;
    const Built& built_;
    const CaseResults& cases_;
    const CaseResult& one_;
    std::string case_;
    const QuestionLog& log_;
    CaseRuns runs_;
    std::vector<Shown> shown_;
};

/// A case that ran to its end, and those of its checks that fail, in the order in which they are shown.
struct WrongCase {
    const CaseResults::value_type* ran;
    std::vector<std::size_t> checks;
};

/// The one whose check is shown first in front: it has most of the time.
std::vector<WrongCase> wrong_cases(const Exercise& exercise, const CaseResults& cases, const UnitResult& result)
{
    const auto order = [&](std::size_t i) {
        return std::pair(exercise.checks[i].hidden, failing_order(&result.checks[i]));
    };
    std::vector<WrongCase> failing;
    for (const auto& ran : cases) {
        if (!ran.second.cause().empty()) continue;
        WrongCase of_case{&ran, {}};
        for (std::size_t i = 0; i < exercise.checks.size(); ++i)
            if (exercise.checks[i].case_name == ran.first && fails(exercise.checks[i], result.checks[i]))
                of_case.checks.push_back(i);
        std::ranges::stable_sort(of_case.checks, {}, order);
        if (!of_case.checks.empty()) failing.push_back(std::move(of_case));
    }
    std::ranges::stable_sort(failing, {}, [&](const WrongCase& one) { return order(one.checks.front()); });
    return failing;
}

/// Where wrong answers are the right ones with the opposite sign, that a question was asked with another sign says the
/// same, and sends one to look at the wrong end.
void drop_negated_questions(UnitResult& result)
{
    const bool has_opposite = std::ranges::any_of(result.checks, [](const CheckResult& check) {
        return check.common_tells == CommonTells::opposite || check.common.ends_with("opposite sign");
    });
    if (!has_opposite) return;
    std::erase_if(result.explanations, [](const Explanation& one) {
        return one.name.starts_with(question_reason) && one.name.find("negated") != std::string::npos;
    });
}

}

void add_questions(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                   UnitResult& result, html::UnitDetail* detail)
{
    const std::string headers = interface_text(worker, exercise);
    SpareTime patterns;
    patterns.allow(most_pattern_seconds);
    // Of a mistake that is known, the checks that are shown first are enough.
    const bool explained = std::ranges::any_of(result.explanations, explains_all);
    SpareTime no_more;
    SpareTime dependence;
    if (!explained) dependence.allow(most_dependence_seconds);
    std::set<bool> shown;  ///< whether they are hidden
    std::set<bool> told;   ///< … and it is known of one what its answers depend on
    for (const WrongCase& failing : wrong_cases(exercise, cases, result)) {
        CaseQuestions questions(worker, exercise, built, cases, failing.ran->first);
        if (!questions.known()) continue;
        for (const std::size_t i : failing.checks) {
            const bool is_first = shown.insert(exercise.checks[i].hidden).second;
            questions.add(exercise.checks[i], result.checks[i], detail, headers,
                          explained && !is_first ? no_more : patterns,
                          told.contains(exercise.checks[i].hidden) ? no_more : dependence);
            if (!result.checks[i].depends.empty()) told.insert(exercise.checks[i].hidden);
        }
        questions.write();
    }
    drop_negated_questions(result);
    add_simplest_question(worker, exercise, built, cases, result);
    add_code_place(worker, exercise, built, cases, result);
    // `umbral debug` has other inputs: no row of its own is meant.
    for (CheckResult& check : result.checks)
        if (check.practice_example) check.practice_example->cell.reset();
}

}
