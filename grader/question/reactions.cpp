#include "question/reactions.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "question/alike.hpp"
#include "question/moved_places.hpp"

#include <umbral/record/not_finite.hpp>

namespace umbral::grader {
namespace {

constexpr std::size_t least_answers = 3;  ///< … in which something is seen
constexpr double least_change = 1e-4;     ///< of a number: less may be rounding
constexpr double most_rest = 2e-6;        ///< of a row's size: so much is rounding

std::span<const double> row_of(const std::vector<double>& table, std::size_t row, std::size_t components)
{
    return std::span(table).subspan(row * components, components);
}

/// What a driver records for infinity (record/not_finite.hpp) is none: beside it all changes would be rounding.
bool are_finite(std::span<const double> numbers)
{
    return std::ranges::all_of(numbers, [](double x) { return std::isfinite(recorded_number(x)); });
}

/// Adds what becomes of the ratio of two numbers; both may have changed.
void add_factor(Reaction& factor, double yours, double right, double yours_moved, double right_moved)
{
    if (yours == 0 || right == 0 || yours_moved == 0 || right_moved == 0) return;
    const double before = yours / right;
    const double after = yours_moved / right_moved;
    factor.add(before, after, std::max(std::abs(before), std::abs(after)));
}

std::vector<Reactions> reactions_to(const MovedAnswers& moved, const AnswersToMoves& answers,
                                    const std::vector<std::size_t>& rows)
{
    std::vector<Reactions> reactions(answers.components);
    for (const std::size_t row : rows) {
        const auto yours = row_of(answers.yours, row, answers.components);
        const auto right = row_of(answers.right, row, answers.components);
        const auto yours_moved = row_of(moved.yours, row, answers.components);
        const auto right_moved = row_of(moved.right, row, answers.components);
        if (!are_finite(yours) || !are_finite(right) || !are_finite(yours_moved) || !are_finite(right_moved)) continue;
        // What is wrong in this place only changes because it becomes right.
        if (alike_rows(yours_moved, right_moved)) continue;
        const double size_of_yours = std::max(size_of(yours), size_of(yours_moved));
        const double size_of_right = std::max(size_of(right), size_of(right_moved));
        for (std::size_t i = 0; i < answers.components; ++i) {
            Reactions& number = reactions[i];
            number.yours.add(yours[i], yours_moved[i], size_of_yours);
            number.right.add(right[i], right_moved[i], size_of_right);
            add_factor(number.factor, yours[i], right[i], yours_moved[i], right_moved[i]);
            number.difference.add(yours[i] - right[i], yours_moved[i] - right_moved[i],
                                  std::max(size_of_yours, size_of_right));
        }
    }
    return reactions;
}

/// Do half of the moves, or more, make this wrong answer right? Then it is wrong in this place only.
bool is_single_place(const AnswersToMoves& answers, std::size_t row)
{
    std::size_t seen = 0;
    std::size_t made_right = 0;
    for (const MovedAnswers& moved : answers.moved) {
        if (moved.yours.size() != answers.yours.size() || moved.right.size() != answers.right.size()) continue;
        const auto yours = row_of(moved.yours, row, answers.components);
        const auto right = row_of(moved.right, row, answers.components);
        if (!are_finite(yours) || !are_finite(right)) continue;
        ++seen;
        made_right += alike_rows(yours, right) ? 1 : 0;
    }
    return seen > 0 && 2 * made_right >= seen;
}

/// Numbers of rows, of one set of inputs.
using RowNumbers = std::vector<std::size_t>;

/// Of each set of inputs the wrong rows, but for those that are wrong in their places only.
std::vector<RowNumbers> wrong_rows(const AnswersToMoves& answers)
{
    std::vector<std::size_t> ends = answers.ends;
    if (ends.empty()) ends.push_back(answers.wrong.size());
    std::vector<RowNumbers> sets;
    std::size_t at = 0;
    for (const std::size_t end : ends) {
        RowNumbers& rows = sets.emplace_back();
        for (; at < end; ++at)
            if (!is_single_place(answers, answers.wrong[at])) rows.push_back(answers.wrong[at]);
    }
    return sets;
}

std::vector<Reactions> reactions_to(const MovedAnswers& moved, const AnswersToMoves& answers,
                                    const std::vector<RowNumbers>& sets)
{
    std::vector<Reactions> all(answers.components);
    if (moved.yours.size() != answers.yours.size() || moved.right.size() != answers.right.size()) return all;
    for (const RowNumbers& rows : sets) {
        const auto some = reactions_to(moved, answers, rows);
        for (std::size_t i = 0; i < all.size(); ++i)
            for (const auto which : {&Reactions::yours, &Reactions::right, &Reactions::factor, &Reactions::difference})
                (all[i].*which).add(some[i].*which);
    }
    return all;
}

}

void Reaction::add(double before, double after, double size)
{
    ++seen;
    const double change = std::abs(after - before);
    if (change > least_change * std::max(std::abs(before), std::abs(after)) && change > 5 * most_rest * size) ++changed;
    if (change <= most_rest * size) ++still;
}

void Reaction::add(const Reaction& others)
{
    is_steady = is_steady && (others.seen <= least_answers || 2 * others.changed >= others.seen);
    seen += others.seen;
    changed += others.changed;
    still += others.still;
}

bool Reaction::changes() const { return seen >= least_answers && is_steady && 2 * changed >= seen; }

bool Reaction::stays() const { return seen >= least_answers && still == seen; }

std::vector<MoveReactions> reactions(const AnswersToMoves& answers)
{
    const std::vector<RowNumbers> sets = wrong_rows(answers);
    std::vector<MoveReactions> all;
    for (const MovedAnswers& moved : answers.moved)
        all.push_back({moved_place(moved.move), reactions_to(moved, answers, sets)});
    return all;
}

}
