#include "explain/simplest_question.hpp"

#include <algorithm>

#include "explain/asked_alone.hpp"
#include "judge/explain/resemblances.hpp"
#include "judge/judges.hpp"
#include "judge/rows/columns.hpp"
#include "judge/rows/rows.hpp"
#include "question/log.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_checks = 2;   ///< for which it is looked for: those that are shown first
constexpr std::size_t most_wrong = 200;  ///< rows of one run whose questions are compared
constexpr double much_shorter = 0.75;    ///< of the first question's length
/// All runs for one check, the reference's too: what is shown beside a wrong value is not worth waiting for longer. Few
/// come near it, since a report must not depend on how busy the machine is.
constexpr double most_seconds = 4;

/// From coarse to fine: the first at which the work is still wrong has the simplest inputs.
constexpr Grain grains[] = {{1, 0}, {2, 0}, {2, 2}, {3, 0}, {4, 0}, {4, 4}, {6, 0}};

/// How much there is to look at in a question: the letters that are shown of it, and the elements of its lists.
struct Size {
    double elements = 0;  ///< of all lists together
    double length = 0;    ///< in letters, of which an element counts as ten
};

Size size_of(const QuestionLog& log, std::uint32_t question, const std::string& code)
{
    constexpr double letters_an_element = 10;
    Size size;
    const bool has_grids = code.find("Grid<") != std::string::npos;
    if (const QuestionKind* kind = log.kind_of(question))
        for (std::size_t i = 0; i < kind->features.size(); ++i) {
            const std::vector<double>& numbers = kind->questions.at(question);
            if (kind->features[i].ends_with(".size()")) size.elements += numbers[i];
            if (has_grids && i > 0 && kind->features[i].ends_with(".height") &&
                kind->features[i - 1].ends_with(".width"))
                size.elements += numbers[i - 1] * numbers[i];
        }
    size.length = static_cast<double>(code.size()) + letters_an_element * size.elements;
    return size;
}

struct Simplest {
    std::optional<Difference> found;
    Size size{};
    std::uint32_t question = 0;
    std::size_t row = 0;

    void offer(const Simplest& other)
    {
        if (other.found && (!found || other.size.length < size.length)) *this = other;
    }
};

/// One failing check, and the inputs with which its first wrong value was found: of a hidden check practice inputs.
struct Search {
    Worker& worker;
    const Exercise& exercise;
    const Built& built;
    const Check& check;
    const Difference& first;
    std::uint64_t seed;
};

/// The size of the question behind the first wrong value.
Size first_size(const Search& search)
{
    const QuestionLog& log = search.worker.questions(search.exercise, search.check.case_name, search.seed);
    const auto question = search.first.cell ? log.question_of(search.check.value, *search.first.cell, 0) : std::nullopt;
    return question ? size_of(log, *question, search.first.question) : Size{};
}

/// How the reference's own rows stand by the check: against the oracle, and with inputs that no driver gives, it may be
/// wrong where only the last digits of what is nearly 0 count, and nobody learns from such a row. Empty where it is
/// right by definition.
std::vector<RowState> states_of_reference(const Check& check, const RunOutcome& reference, const Expected& side)
{
    if (judged_against(check) == Answers::reference) return {};
    const Tensor* const rows = observed(check, reference);
    return has_single_rows(check, rows, side.value) ? single_rows(check, *rows, side) : std::vector<RowState>();
}

/// The wrong rows of one run, each with its question. False if the run took its whole time: another would, too.
bool look_at(const Search& search, const Grain& grain, Simplest& simplest)
{
    const auto& [worker, exercise, built, check, first, seed] = search;
    const auto ask = [&](Answers solution, Inquiry inquiry) {
        inquiry.grain = grain;
        return search.worker.inquire(search.exercise, solution, search.check.case_name, search.seed, inquiry);
    };
    const RunOutcome told = ask(Answers::reference, {.questions = true});
    if (told.verdict != Verdict::ok) return true;
    const RunOutcome expected = judged_against(check) == Answers::reference ? told : ask(Answers::oracle, {});
    if (expected.verdict != Verdict::ok) return true;
    const RunOutcome student = worker.run_coarse(exercise, built, check.case_name, seed, grain, expected);
    const Expected side = expected_of(check, expected);
    const Tensor* yours = observed(check, student);
    if (student.verdict == Verdict::timeout) return false;
    // A generator that draws from few bits can draw a null vector where it promises another: nobody has to answer then.
    if (side.value == nullptr || !all_finite(to_doubles(*side.value))) return true;
    if (student.verdict != Verdict::ok || !has_single_rows(check, yours, side.value)) return true;
    const QuestionLog log = read_questions(told.recording.tensors);
    const std::vector<RowState> states = single_rows(check, *yours, side);
    const std::vector<RowState> references = states_of_reference(check, told, side);
    std::map<std::uint32_t, std::size_t> rows;
    for (std::size_t row = 0; row < states.size() && rows.size() < most_wrong; ++row)
        if (const auto question = log.question_of(check.value, row, states.size());
            states[row] == RowState::wrong && question &&
            (row >= references.size() || references[row] != RowState::wrong))
            rows.emplace(*question, row);
    if (rows.empty()) return true;
    Inquiry inquiry;
    for (const auto& [question, row] : rows) inquiry.wanted.push_back(question);
    const RunOutcome written = ask(Answers::reference, inquiry);
    if (written.verdict != Verdict::ok) return true;
    const RowKind& kind = rows_of(check);
    const TensorView view(*yours);
    const TensorView right(*side.value);
    const auto columns = column_names(text_of(side.names), right.components(), check.value);
    Simplest best;
    for (const auto& [question, code] : read_questions(written.recording.tensors).code) {
        const auto found = rows.find(question);
        // Of few bits a vector may be null, and what the driver makes of it no number: no question of the unit's.
        if (found == rows.end() || code.find("NAN") != std::string::npos) continue;
        const RowPairs pairs{check, view, right, kind, columns};
        const auto [where, mine, reference, cell, none, others] = row_difference(pairs, found->second);
        best.offer({Difference{wrong_columns(pairs, found->second), mine, reference, std::nullopt, code},
                    size_of(log, question, code), question, found->second});
    }
    if (!best.found || (simplest.found && simplest.size.length <= best.size.length)) return true;
    // What is wrong only after other questions shows nothing.
    const RunOutcome alone =
        worker.run_coarse(exercise, built, check.case_name, seed, grain, expected, only(best.question));
    const AskedRow asked{log, best.question, best.row};
    if (is_row_right(check, alone, side, asked)) return true;
    // Nor does a line of a script that needs the ones before it, as whether nothing is left at the end.
    if (log.kind_of(best.question) == nullptr) {
        const RunOutcome right =
            worker.trusted_past(exercise, judged_against(check), check.case_name, seed, only(best.question), grain);
        if (!is_row_right(check, right, side, asked)) return true;
    }
    simplest.offer(best);
    return true;
}

/// From coarse to fine, until finer inputs have no simpler question. False if there is no time to go on, for other
/// checks neither.
bool look_at_grains(const Search& search, Simplest& simplest)
{
    SpareTime time;
    time.allow(most_seconds);
    for (const Grain& grain : grains) {
        if (!search.worker.spare_time().is_left() || !time.is_left()) return false;
        const double before = search.worker.run_seconds();
        const std::optional<double> length = simplest.found ? std::optional(simplest.size.length) : std::nullopt;
        if (!look_at(search, grain, simplest)) return false;
        if (length && simplest.size.length >= *length) return true;
        time.spend(search.worker.run_seconds() - before);
    }
    return true;
}

/// The first wrong value that a student is shown.
const std::optional<Difference>& shown_first(const CheckResult& result)
{
    return result.hidden ? result.practice_example : result.first_difference;
}

bool can_be_simpler(const Check& check, const CheckResult& result)
{
    const JudgeRecord& judge = judge_of(check);
    const std::optional<Difference>& first = shown_first(result);
    // Where the answer depends on the calls before, another question shows nothing.
    return !keeps_something(result) && result.score < check.points && !check.relation && !judge.free_rows &&
           judge.plain_values && judge.look == Look::none && first && !first->question.empty();
}

}

void add_simplest_question(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases,
                           UnitResult& result)
{
    std::vector<std::size_t> checks;
    for (std::size_t i = 0; i < exercise.checks.size(); ++i)
        if (can_be_simpler(exercise.checks[i], result.checks[i]) &&
            may_repeat(worker, exercise, cases.at(exercise.checks[i].case_name)))
            checks.push_back(i);
    // What everybody sees first.
    std::ranges::stable_sort(checks, {}, [&](std::size_t i) {
        return std::pair(result.checks[i].hidden, judge_of(exercise.checks[i]).place);
    });
    if (checks.size() > most_checks) checks.resize(most_checks);
    for (const std::size_t i : checks) {
        CheckResult& of_check = result.checks[i];
        const Check& check = exercise.checks[i];
        const std::uint64_t seed = check.hidden ? of_check.practice_seed : cases.at(check.case_name).seed;
        const Search search{worker, exercise, built, check, *shown_first(of_check), seed};
        Simplest simplest;
        const bool in_time = look_at_grains(search, simplest);
        // Smaller numbers in longer lists are not simpler.
        const Size first = simplest.found ? first_size(search) : Size{};
        if (simplest.found && simplest.size.length < much_shorter * first.length &&
            simplest.size.elements <= first.elements) {
            if (check.hidden)
                of_check.practice_example = std::move(simplest.found);
            else
                of_check.simplest = std::move(simplest.found);
        }
        if (!in_time) return;
    }
}

}
