#include "question/answer_patterns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <span>

#include "question/alike.hpp"
#include "question/answer_relations.hpp"
#include "question/nearly_right.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_named = 4;  ///< more numbers of a row than that are no pattern

using Pairs = std::vector<const AnswerPair*>;

bool alike_rows(std::span<const double> a, std::span<const double> b)
{
    const double size = size_of(b);
    return std::ranges::equal(a, b, [size](double x, double y) { return alike(x, y, size); });
}

bool all_equal(const Pairs& pairs, const std::vector<double> AnswerPair::*side)
{
    return std::ranges::all_of(pairs,
                               [&](const AnswerPair* one) { return alike_rows(one->*side, pairs.front()->*side); });
}

/// "0", "(0, 0, 1)"
std::string in_words(std::span<const double> numbers)
{
    if (numbers.size() == 1) return fmt::format("{:.6g}", numbers.front());
    std::vector<std::string> all;
    for (const double number : numbers) all.push_back(fmt::format("{:.6g}", number));
    return fmt::format("({})", fmt::join(all, ", "));
}

/// Whether there is an answer, and whether it is one at all; empty if nothing is to say.
std::string presence(const Pairs& wrong)
{
    if (std::ranges::all_of(wrong, [](const AnswerPair* one) { return one->yours.empty(); })) return "is empty";
    if (std::ranges::all_of(wrong, [](const AnswerPair* one) { return one->expected.empty(); }))
        return "should be empty";
    const bool infinite = std::ranges::all_of(wrong, [](const AnswerPair* one) {
        return std::ranges::any_of(one->yours, [](double x) { return !std::isfinite(x); });
    });
    return infinite ? "is not finite" : "";
}

/// Where all have the same size and are finite.
bool can_be_compared(const Pairs& wrong)
{
    return std::ranges::all_of(wrong, [](const AnswerPair* one) {
        const auto finite = [](double x) { return std::isfinite(x); };
        return !one->expected.empty() && one->yours.size() == one->expected.size() &&
               std::ranges::all_of(one->yours, finite) && std::ranges::all_of(one->expected, finite);
    });
}

void add_constant(const Pairs& wrong, std::vector<std::string>& found)
{
    constexpr std::size_t most_numbers = 4;
    if (wrong.front()->yours.size() > most_numbers || wrong.front()->yours.empty()) return;
    if (all_equal(wrong, &AnswerPair::yours) && !all_equal(wrong, &AnswerPair::expected))
        found.push_back("is always " + in_words(wrong.front()->yours));
}

/// The rows of a list in which one row, or the order, is wrong.
void add_lists(const Pairs& wrong, std::size_t components, std::vector<std::string>& found)
{
    const auto all = [&](auto holds) {
        return std::ranges::all_of(wrong, [&](const AnswerPair* one) {
            return one->expected.size() > components && holds(std::span(one->yours), std::span(one->expected));
        });
    };
    using Rows = std::span<const double>;
    if (all([&](Rows yours, Rows right) { return alike_rows(yours, right.first(right.size() - components)); }))
        found.emplace_back("lacks the last row");
    if (all([&](Rows yours, Rows right) { return alike_rows(yours, right.subspan(components)); }))
        found.emplace_back("lacks the first row");
    if (all([&](Rows yours, Rows right) {
            return yours.size() == right.size() + components && alike_rows(yours.first(right.size()), right);
        }))
        found.emplace_back("has a row too many at its end");
    if (all([&](Rows yours, Rows right) {
            return yours.size() == right.size() + components && alike_rows(yours.subspan(components), right);
        }))
        found.emplace_back("has a row too many at its beginning");
    if (all([&](Rows yours, Rows right) {
            if (yours.size() != right.size()) return false;
            std::vector<double> turned;
            for (std::size_t at = yours.size(); at > 0; at -= components)
                turned.insert(turned.end(), yours.begin() + static_cast<long>(at - components),
                              yours.begin() + static_cast<long>(at));
            return alike_rows(turned, right);
        }))
        found.emplace_back("has its rows in the opposite order");
}

/// The components in which some wrong answer differs by more than rounding.
std::vector<std::size_t> wrong_components(const Pairs& wrong, std::size_t components)
{
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < components; ++i)
        if (std::ranges::any_of(wrong, [&](const AnswerPair* one) {
                const double size = size_of(one->expected);
                for (std::size_t at = i; at < one->yours.size(); at += components)
                    if (!alike(one->yours[at], one->expected[at], size)) return true;
                return false;
            }))
            found.push_back(i);
    return found;
}

/// What turns each right number into the wrong one beside it, if it is the same everywhere: "the right one plus 1".
std::optional<std::string> constant_change(const Pairs& wrong, std::size_t components, std::size_t component)
{
    std::optional<double> offset;
    std::optional<double> factor;
    bool same_offset = true;
    bool same_factor = true;
    double least = INFINITY;
    double most = -INFINITY;
    for (const AnswerPair* one : wrong)
        for (std::size_t at = component; at < one->yours.size(); at += components) {
            const double yours = one->yours[at];
            const double right = one->expected[at];
            const double size = std::max(std::abs(yours), std::abs(right));
            least = std::min(least, right);
            most = std::max(most, right);
            if (!offset) offset = yours - right;
            same_offset = same_offset && alike(yours - right, *offset, size);
            if (right == 0) {
                same_factor = same_factor && yours == 0;
                continue;
            }
            if (!factor) factor = yours / right;
            same_factor = same_factor && alike(yours / right, *factor, std::abs(*factor));
        }
    // Of a single right value anything is true.
    if (!(least < most)) return std::nullopt;
    if (same_offset && *offset != 0)
        return fmt::format("the right one {} {:.6g}", *offset > 0 ? "plus" : "minus", std::abs(*offset));
    if (!same_factor || !factor || *factor == 0) return std::nullopt;
    if (alike(*factor, 1, 1)) return std::nullopt;
    if (alike(*factor, -1, 1)) return "the right one with the opposite sign";
    return fmt::format("{:.6g} times the right one", *factor);
}

/// Where each answer is one row: which question it answers.
std::vector<std::size_t> questions_of(const AnswerTable& table, const Pairs& wrong)
{
    std::vector<std::size_t> questions;
    for (const AnswerPair* one : wrong)
        if (one->yours.size() == table.components)
            questions.push_back(static_cast<std::size_t>(one - table.answers.data()));
    if (questions.size() != wrong.size()) questions.clear();
    return questions;
}

/// What each wrong number in this place of a row is: "the right one plus 1".
std::optional<std::string> change_of(const AnswerTable& table, const Pairs& wrong, std::size_t component)
{
    if (auto change = constant_change(wrong, table.components, component)) return change;
    WrongNumbers numbers{{}, {}, questions_of(table, wrong)};
    if (numbers.questions.empty()) return std::nullopt;
    for (const AnswerPair* one : wrong) {
        numbers.yours.push_back(one->yours[component]);
        numbers.right.push_back(one->expected[component]);
    }
    return relation_of(numbers, table.facts);
}

/// So many numbers of each row, from this one on, as vectors; none where an answer is not one row.
WrongVectors wrong_vectors(const AnswerTable& table, const Pairs& wrong, std::size_t first, std::size_t count)
{
    WrongVectors vectors{count, {}, {}, {}, questions_of(table, wrong)};
    if (vectors.questions.empty()) return vectors;
    for (const AnswerPair* one : wrong) {
        vectors.yours.push_back(std::span(one->yours).subspan(first, count));
        vectors.right.push_back(std::span(one->expected).subspan(first, count));
    }
    return vectors;
}

/// What each of the wrong columns of square matrices is, if that can be said of all of them.
void add_matrix_columns(const AnswerTable& table, const Pairs& wrong, const std::vector<std::size_t>& which,
                        std::vector<std::string>& found)
{
    const std::size_t side = table.components == 16 ? 4 : 3;
    if (side * side != table.components) return;
    std::set<std::size_t> columns;
    for (const std::size_t i : which) columns.insert(i / side);
    const bool affine = side == 4 && std::ranges::none_of(which, [](std::size_t i) { return i % 4 == 3; });
    std::vector<std::string> parts;
    std::set<std::string> relations;
    for (const std::size_t column : columns) {
        const auto relation = relation_of(wrong_vectors(table, wrong, column * side, affine ? 3 : side), table.facts);
        if (!relation) return;
        parts.push_back(fmt::format("column {} {}", column, *relation));
        relations.insert(*relation);
    }
    if (columns.size() < side)
        found.push_back(fmt::format("is right but for some columns: {}", fmt::join(parts, ", ")));
    else if (relations.size() == 1)
        found.push_back("has columns each of which " + *relations.begin());
    else
        found.push_back(fmt::format("is wrong in all columns: {}", fmt::join(parts, ", ")));
}

/// State that a call leaves behind for the next.
void add_question_before(const AnswerTable& table, const Pairs& wrong, std::vector<std::string>& found)
{
    std::set<std::vector<double>> different;
    for (const AnswerPair* one : wrong) {
        if (one == table.answers.data() || !alike_rows(one->yours, (one - 1)->expected)) return;
        different.insert(one->yours);
    }
    if (different.size() >= least_wrong) found.emplace_back("is the right one to the question before");
}

/// Which numbers of a row are wrong; empty if most of what it says is.
std::string place_of(const AnswerTable& table, const std::vector<std::size_t>& which)
{
    if (which.empty() || which.size() > most_named || 2 * which.size() > table.components - table.keys) return "";
    // Nobody can count along a row whose numbers have no names, and that begins with what is no number of its own.
    if (table.keys > 0 && table.columns.empty() && which.size() > 1) return "";
    std::vector<std::string> names;
    for (const std::size_t i : which)
        names.push_back(i < table.columns.size()            ? table.columns[i]
                        : table.keys > 0 && i >= table.keys ? fmt::format("its number {}", i - table.keys + 1)
                                                            : fmt::format("number {}", i));
    return which.size() == 1 ? fmt::format("differs in {} only", names.front())
                             : fmt::format("differs in nothing but {}", fmt::join(names, ", "));
}

/// What is so of the numbers of an answer, the most telling first.
void add_components(const AnswerTable& table, const Pairs& wrong, std::vector<std::string>& found)
{
    const std::vector<std::size_t> which = wrong_components(wrong, table.components);
    const auto change = which.size() == 1 ? change_of(table, wrong, which.front()) : std::nullopt;
    if (which.size() > 1 && table.components <= 4) {
        WrongVectors vectors = wrong_vectors(table, wrong, 0, table.components);
        if (table.columns.size() == table.components) vectors.names = table.columns;
        if (auto relation = relation_of(vectors, table.facts)) found.push_back(std::move(*relation));
    }
    if (which.size() > 1) add_matrix_columns(table, wrong, which, found);
    const std::string place = table.components == 1 ? "" : place_of(table, which);
    if (change && table.components == 1) found.push_back("is " + *change);
    if (change && !place.empty()) found.push_back(fmt::format("{}, which is {}", place, *change));
    if (are_nearly_right(table, wrong))
        found.push_back(place.empty() ? nearly_right : fmt::format("{}, and {}", place, nearly_right));
    if (!place.empty()) found.push_back(place);
}

}

std::vector<std::string> answer_patterns(const AnswerTable& table)
{
    Pairs wrong;
    for (const AnswerPair& one : table.answers)
        if (one.wrong) wrong.push_back(&one);
    std::vector<std::string> found;
    if (wrong.size() < least_wrong) {
        // Of so few anything may be true, but that the same numbers of a row are wrong is what is seen.
        if (wrong.size() < 2 || !can_be_compared(wrong)) return found;
        const std::string place = place_of(table, wrong_components(wrong, table.components));
        if (!place.empty()) found.push_back(place);
        return found;
    }
    if (const std::string text = presence(wrong); !text.empty()) return {text};
    add_constant(wrong, found);
    add_lists(wrong, table.components, found);
    if (can_be_compared(wrong)) {
        add_question_before(table, wrong, found);
        add_components(table, wrong, found);
    }
    return found;
}

}
