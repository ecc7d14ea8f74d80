#include "question/dependence.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "question/alike.hpp"

#include <umbral/record/not_finite.hpp>

namespace umbral::grader {
namespace {

constexpr std::size_t least_answers = 3;  ///< … in which something is seen
constexpr std::size_t most_places = 3;    ///< that are told, and numbers of which it is told
constexpr double least_change = 1e-4;     ///< of a number: less may be rounding
constexpr double most_rest = 2e-6;        ///< of a row's size: so much is rounding

/// What becomes of one number as an argument is moved.
struct Reaction {
    std::size_t seen = 0;
    std::size_t changed = 0;
    std::size_t still = 0;
    bool is_steady = true;  ///< as in all, most changed in each set of inputs

    void add(double before, double after, double size)
    {
        ++seen;
        const double change = std::abs(after - before);
        if (change > least_change * std::max(std::abs(before), std::abs(after)) && change > 5 * most_rest * size)
            ++changed;
        if (change <= most_rest * size) ++still;
    }
    [[nodiscard]] bool changes() const { return seen >= least_answers && is_steady && 2 * changed >= seen; }
    /// With the answers to other inputs.
    void add(const Reaction& others)
    {
        is_steady = is_steady && (others.seen <= least_answers || 2 * others.changed >= others.seen);
        seen += others.seen;
        changed += others.changed;
        still += others.still;
    }
    [[nodiscard]] bool stays() const { return seen >= least_answers && still == seen; }
};

struct Reactions {
    Reaction yours{};
    Reaction right{};
};

std::span<const double> row_of(const std::vector<double>& table, std::size_t row, std::size_t components)
{
    return std::span(table).subspan(row * components, components);
}

/// What a driver records for infinity (record/not_finite.hpp) is none: beside it all changes would be rounding.
bool are_finite(std::span<const double> numbers)
{
    return std::ranges::all_of(numbers, [](double x) { return std::isfinite(recorded_number(x)); });
}

/// For each number of the answers, over wrong rows that have numbers before and after on both sides, and remain wrong.
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
            reactions[i].yours.add(yours[i], yours_moved[i], size_of_yours);
            reactions[i].right.add(right[i], right_moved[i], size_of_right);
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
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i].yours.add(some[i].yours);
            all[i].right.add(some[i].right);
        }
    }
    return all;
}

/// "0.size.x" of "0.size" and "moved .x".
MovedPlace place_of(const OtherQuestion& move)
{
    constexpr std::string_view moved = "moved";
    std::string_view what = std::string_view(move.change).substr(moved.size());
    if (what.starts_with(' ')) what.remove_prefix(1);
    const bool is_length = what == "length";
    const bool is_order = what == "order";
    const bool is_corners = what == "corners";
    if (what == "direction" || is_length || is_order || is_corners) what = {};
    return {move.function, move.place + std::string(what), is_length, is_order, is_corners};
}

/// The vector that a component is one of; nothing if it is none.
std::optional<MovedPlace> vector_of(const MovedPlace& place)
{
    const std::size_t dot = place.place.rfind('.');
    const bool is_component = dot != std::string::npos && dot + 2 == place.place.size() &&
                              std::string_view("xyzw").find(place.place.back()) != std::string_view::npos;
    if (!is_component) return std::nullopt;
    return MovedPlace{place.function, place.place.substr(0, dot)};
}

/// A vector in place of three of its components, or of one beside its length.
void join_components(std::set<MovedPlace>& places)
{
    std::map<MovedPlace, std::size_t> components;
    for (const MovedPlace& place : places)
        if (const auto vector = vector_of(place)) ++components[*vector];
    std::set<MovedPlace> whole;
    for (const MovedPlace& place : places)
        if (!place.is_length && !vector_of(place)) whole.insert(place);
    for (const auto& [vector, count] : components)
        if (count >= 3 || places.contains({vector.function, vector.place, true})) whole.insert(vector);
    std::erase_if(places, [&](const MovedPlace& place) {
        const auto vector = vector_of(place);
        return (vector && whole.contains(*vector)) ||
               (place.is_length && whole.contains({place.function, place.place, false}));
    });
    places.merge(whole);
}

std::vector<MovedPlace> told(std::set<MovedPlace> places)
{
    join_components(places);
    if (places.size() > most_places) return {};
    return {places.begin(), places.end()};
}

}

std::vector<Dependence> dependences(const AnswersToMoves& answers)
{
    std::vector<Dependence> all;
    std::vector<std::vector<Reactions>> reactions;
    const std::vector<RowNumbers> sets = wrong_rows(answers);
    for (const MovedAnswers& moved : answers.moved) reactions.push_back(reactions_to(moved, answers, sets));
    for (std::size_t i = 0; i < answers.components; ++i) {
        std::set<MovedPlace> wrongly;
        std::set<MovedPlace> lacking;
        bool is_constant = true;
        bool is_like_right = false;  ///< something is used as it should be
        for (std::size_t m = 0; m < answers.moved.size(); ++m) {
            const auto& [yours, right] = reactions[m][i];
            is_constant = is_constant && yours.changed == 0;
            is_like_right = is_like_right || (yours.changes() && right.changes());
            if (yours.changes() && right.stays()) wrongly.insert(place_of(answers.moved[m].move));
            if (right.changes() && yours.stays()) lacking.insert(place_of(answers.moved[m].move));
        }
        if (is_constant) continue;
        Dependence one{{i}, told(std::move(wrongly)), told(std::move(lacking))};
        if (one.wrongly.empty() && (one.lacking.empty() || !is_like_right)) continue;
        const auto same = std::ranges::find_if(
            all, [&](const Dependence& other) { return other.wrongly == one.wrongly && other.lacking == one.lacking; });
        if (same != all.end())
            same->components.push_back(i);
        else
            all.push_back(std::move(one));
    }
    return all;
}

}
