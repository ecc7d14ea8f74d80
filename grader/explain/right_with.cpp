#include "explain/right_with.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include "explain/answers_left.hpp"
#include "explain/as_other_mistakes.hpp"
#include "explain/other_answers.hpp"
#include "explain/question_words.hpp"
#include "explain/questions_in_turn.hpp"
#include "explain/samples.hpp"
#include "explain/simpler_questions.hpp"
#include "judge/judges.hpp"
#include "question/possible_conditions.hpp"

namespace umbral::grader {
namespace {

/// Of practice inputs, behind those that dependences are looked for on; and so many sets.
constexpr std::size_t fresh_changes_place = 13;
constexpr std::size_t fresh_sets = 4;
constexpr std::size_t most_fresh_sets = 14;
constexpr std::size_t fresh_sets_of_drawings = 2;  ///< each takes a hundred times as long
constexpr std::size_t most_changes_tried = 160;
constexpr double most_seconds_of_changes = 1;  ///< of the reference's runs
constexpr std::size_t most_changes_told = 2;
constexpr std::size_t most_changed_places = 3;    ///< with more, it is right nearly everywhere else
constexpr double most_times_as_far = 2;           ///< beside another: one that changes more says less
constexpr double most_times_as_far_left_out = 4;  ///< what is left out says more than another number
constexpr double least_gl_seconds = 0.1;          ///< a run that draws, whatever the processor says
constexpr double most_seconds_of_mistakes = 1.5;  ///< in finding out whether it is so of most mistakes

/// Is the same place changed as by `question`?
auto changes_at(const OtherQuestion& question)
{
    return [&question](const OtherAnswers& other) {
        return other.question.function == question.function && other.question.place == question.place;
    };
}

/// A check with the inputs of one seed: which of its answers are wrong as they were asked.
struct AskedOnce {
    std::uint64_t seed;
    const Tensor* right;
    std::optional<std::vector<std::size_t>> rows{};  ///< answers of the function; none: the check is judged as a whole
    std::size_t wrong = 0;
    std::vector<std::size_t> wrong_rows{};  ///< of `rows`
};

class RightWith {
public:
    RightWith(Worker& worker, const AskedCheck& asked, SpareTime& time) : worker_(worker), asked_(asked), time_(time) {}

    [[nodiscard]] std::vector<OtherQuestion> found()
    {
        const std::optional<AskedOnce> first = asked_at(input_seed(asked_, 0));
        if (!first || first->wrong == 0) return {};
        std::vector<OtherAnswers> tried = candidates(*first);
        keep_right(*first, tried);
        keep_nearest(*first, tried);
        drop_moved(*first, tried);
        if (places_of(tried) > most_changed_places) return {};
        // One number in the place of another leads few questions away from what is wrong, whatever that is.
        if (first->rows && first->wrong < least_questions)
            std::erase_if(tried, [](const OtherAnswers& one) {
                return !one.question.other.empty() || one.question.change.starts_with("with ");
            });
        drop_what_is_so_of_most(*first, tried);
        if (tried.empty()) return {};
        count(*first);
        bool is_confirmed = first->wrong > 1;
        const std::size_t sets = asked_.exercise.gl ? fresh_sets_of_drawings : fresh_sets;
        // Where few answers are wrong, it takes more inputs to tell.
        const auto is_another_needed = [&](std::size_t i) {
            return i < sets || (i < most_fresh_sets && are_right_by_chance(asked_rows_, wrong_rows_));
        };
        for (std::size_t i = 0; !tried.empty() && is_another_needed(i); ++i) {
            const std::optional<AskedOnce> fresh = asked_at(varied_seed(asked_, fresh_changes_place + i));
            if (!fresh || fresh->wrong == 0) continue;
            keep_right(*fresh, tried, is_confirmed);
            if (time_.is_left()) count(*fresh);
            is_confirmed = true;
        }
        if (are_right_by_chance(asked_rows_, wrong_rows_)) return {};
        std::vector<OtherQuestion> changes;
        for (OtherAnswers& one : tried)
            if (is_confirmed && changes.size() < most_changes_told) changes.push_back(std::move(one.question));
        return changes;
    }

    [[nodiscard]] std::optional<bool> holds(std::uint64_t seed, const OtherQuestion& change)
    {
        const std::optional<AskedOnce> once = asked_at(seed);
        if (!once || once->wrong == 0) return std::nullopt;
        std::vector<OtherAnswers> tried{{change}};
        keep_right(*once, tried);
        return !tried.empty();
    }

private:
    [[nodiscard]] std::optional<AskedOnce> asked_at(std::uint64_t seed)
    {
        const Check& check = asked_.check;
        const RunOutcome& expected = worker_.trusted(asked_.exercise, judged_against(check), check.case_name, seed);
        const RunOutcome& student = asked_.runs.plain(seed);
        const Tensor* const right = tensor_of(expected, check.value);
        const Tensor* const yours = observed(check, student);
        if (expected.verdict != Verdict::ok || student.verdict != Verdict::ok || right == nullptr ||
            !well_formed(*right) || yours == nullptr || !well_formed(*yours))
            return std::nullopt;
        const AskedAnswers answers = asked_answers(worker_, asked_, seed);
        const QuestionLog& log = questions_at(worker_, asked_, seed);
        if (function_.empty()) function_ = function_asked_most(answers, log);
        if (function_.empty()) function_ = function_asked_most(log, check.value);
        if (function_.empty()) return std::nullopt;
        AskedOnce once{seed, right};
        if (has_single_rows(check, yours, right)) {
            once.rows.emplace();
            for (const AskedAnswer& answer : answers.all) {
                const QuestionKind* const kind = log.kind_of(answer.question);
                if (!answer.row || kind == nullptr || kind->function != function_) continue;
                once.rows->push_back(*answer.row);
                if (answer.answer.wrong) once.wrong_rows.push_back(*answer.row);
            }
            once.wrong = once.wrong_rows.size();
        } else {
            once.wrong = judged_right(*yours, expected) ? 0 : 1;
        }
        return once;
    }

    void count(const AskedOnce& once)
    {
        if (!once.rows) return;
        asked_rows_ += once.rows->size();
        wrong_rows_ += once.wrong;
    }

    /// By the check's rule; what it cannot judge of other questions' right answers is not right.
    [[nodiscard]] bool judged_right(const Tensor& yours, const RunOutcome& right) const
    {
        const Expected expected = expected_of(asked_.check, right);
        if (expected.value->rows == 0 || yours.rows == 0) return expected.value->rows == yours.rows;
        try {
            return judge(asked_.check, yours, *expected.value, expected.margin, expected.names).right >= 1;
        } catch (const std::invalid_argument&) {
            return false;
        }
    }

    /// Changes of the function's arguments, and of what its objects have their state from.
    [[nodiscard]] std::vector<OtherAnswers> candidates(const AskedOnce& once)
    {
        const QuestionLog& log = questions_at(worker_, asked_, once.seed);
        const RunOutcome& expected =
            worker_.trusted(asked_.exercise, judged_against(asked_.check), asked_.check.case_name, once.seed);
        const bool draws = asked_.exercise.gl && leaves_picture(expected);
        const double seconds = std::max(seconds_of_other(expected, log), draws ? least_gl_seconds : 1e-4);
        const auto most = static_cast<std::size_t>(most_seconds_of_changes / seconds);
        std::vector<OtherQuestion> simpler = simpler_questions(log, function_, asked_.headers);
        // Less of a mesh is less of a picture, whatever is wrong with it.
        if (asked_.exercise.gl && function_.find("::") != std::string::npos)
            std::erase_if(simpler, [](const OtherQuestion& one) { return is_of_list(one); });
        simpler.resize(std::min({simpler.size(), most, most_changes_tried}));
        std::vector<OtherAnswers> all;
        for (OtherQuestion& question : simpler) all.push_back({std::move(question)});
        return all;
    }

    /// Asks, and leaves those with which all answers are right; and where that is `confirmed`, those for which there is
    /// no time.
    void keep_right(const AskedOnce& once, std::vector<OtherAnswers>& tried, bool confirmed = false)
    {
        for (OtherAnswers& one : tried) one = {std::move(one.question)};
        ask_both(worker_, asked_, once.seed, tried, time_);
        const bool is_kept = confirmed && !time_.is_left();
        std::erase_if(tried,
                      [&](const OtherAnswers& one) { return one.answered ? !makes_right(once, one) : !is_kept; });
    }

    [[nodiscard]] bool makes_right(const AskedOnce& once, const OtherAnswers& one) const
    {
        const Tensor* const yours = observed(asked_.check, one.yours);
        const Expected expected = expected_of(asked_.check, one.right);
        if (yours == nullptr || !well_formed(*yours) || expected.value == nullptr || !well_formed(*expected.value) ||
            !leaves_answers(one.question, *once.right, *expected.value))
            return false;
        if (!once.rows) return judged_right(*yours, one.right);
        if (!has_single_rows(asked_.check, yours, expected.value)) return false;
        // Where nothing can be found any more, everybody is right.
        if (settles_presence(*once.right, *expected.value, once.wrong_rows)) return false;
        try {
            const std::vector<RowState> states = single_rows(asked_.check, *yours, expected);
            return std::ranges::all_of(
                *once.rows, [&](std::size_t row) { return row < states.size() && states[row] == RowState::right; });
        } catch (const std::invalid_argument&) {
            return false;
        }
    }

    /// What a small change of the same makes right, too, is wrong in single places only: of these, conditions tell.
    void drop_moved(const AskedOnce& once, std::vector<OtherAnswers>& tried)
    {
        const QuestionLog& log = questions_at(worker_, asked_, once.seed);
        std::vector<OtherAnswers> moved;
        for (const OtherQuestion& move : log.moves)
            if (move.change != "moved order" && std::ranges::any_of(tried, changes_at(move))) moved.push_back({move});
        keep_right(once, moved);
        std::erase_if(tried,
                      [&](const OtherAnswers& one) { return std::ranges::any_of(moved, changes_at(one.question)); });
    }

    /// With no light, all shadows are right, whatever is wrong with them. What there is no time to find out of is left
    /// out too.
    void drop_what_is_so_of_most(const AskedOnce& once, std::vector<OtherAnswers>& tried)
    {
        if (tried.empty()) return;
        OtherMistakes mistakes(worker_, asked_);
        SpareTime time;
        time.allow(most_seconds_of_mistakes);
        std::erase_if(tried, [&](const OtherAnswers& one) {
            const bool is_so = mistakes.most([&](const AskedCheck& mistake) -> std::optional<bool> {
                RightWith other(worker_, mistake, time);
                other.function_ = function_;
                const std::optional<AskedOnce> plain = time.is_left() ? other.asked_at(once.seed) : std::nullopt;
                if (!plain || plain->wrong == 0) return std::nullopt;
                RunOutcome run =
                    time.spent_on(worker_.run_moved(asked_.exercise, mistake.runs.built(), asked_.check.case_name,
                                                    once.seed, {one.question}, asked_.check.value));
                if (run.verdict != Verdict::ok) return std::nullopt;
                return makes_right(*plain, {one.question, true, std::move(runs_of_others(run, 1).front()), one.right});
            });
            return is_so || !time.is_left();
        });
    }

    [[nodiscard]] static std::size_t places_of(const std::vector<OtherAnswers>& tried)
    {
        std::set<std::pair<std::string, std::string>> places;
        for (const OtherAnswers& one : tried) places.emplace(one.question.function, one.question.place);
        return places.size();
    }

    /// Puts in front what changes the right answers least, which says most, and leaves out what changes far more, and
    /// what does the same as another.
    void keep_nearest(const AskedOnce& once, std::vector<OtherAnswers>& tried) const
    {
        const auto answers = [&](const OtherAnswers& one) { return tensor_of(one.right, asked_.check.value); };
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < tried.size(); ++i)
            order.emplace_back(share_changed(*once.right, *answers(tried[i])) /
                                   (leaves_out(tried[i].question) ? most_times_as_far_left_out : 1),
                               i);
        std::ranges::sort(order);
        std::vector<OtherAnswers> kept;
        for (const auto& [far, i] : order) {
            const auto is_like = [&](const OtherAnswers& other) { return *answers(other) == *answers(tried[i]); };
            if (far <= most_times_as_far * order.front().first && std::ranges::none_of(kept, is_like))
                kept.push_back(tried[i]);
        }
        tried = std::move(kept);
    }

    Worker& worker_;
    const AskedCheck& asked_;
    SpareTime& time_;
    std::string function_;
    std::size_t asked_rows_ = 0;  ///< of all inputs that were looked at
    std::size_t wrong_rows_ = 0;
};

}

std::vector<OtherQuestion> changes_that_make_right(Worker& worker, const AskedCheck& asked, SpareTime& time)
{
    if (!time.is_left() || asked.check.relation) return {};
    return RightWith(worker, asked, time).found();
}

std::string right_with(const std::vector<OtherQuestion>& changes, const std::string& headers)
{
    std::string text;
    for (const OtherQuestion& change : changes)
        text += std::string(text.empty() ? right_with_words : ", or with ") + in_words(change, headers);
    return text.empty() ? "" : text + ", your answers are right";
}

std::optional<bool> is_right_with(Worker& worker, const AskedCheck& asked, std::uint64_t seed,
                                  const OtherQuestion& change, SpareTime& time)
{
    return RightWith(worker, asked, time).holds(seed, change);
}

}
