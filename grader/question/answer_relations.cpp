#include "question/answer_relations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#include "question/alike.hpp"
#include "question/number_changes.hpp"
#include "question/told_as.hpp"

namespace umbral::grader {
namespace {

template <class Make>
std::vector<double> made_of(std::span<const double> a, std::span<const double> b, Make make)
{
    std::vector<double> made(a.size());
    std::ranges::transform(a, b, made.begin(), make);
    return made;
}

/// Right ones whose factor and offset are the same for all.
std::optional<std::string> linear(std::span<const double> yours, std::span<const double> right)
{
    if (!are_varied(right)) return std::nullopt;
    const auto [low, high] = std::ranges::minmax_element(right);
    const auto at = [&](auto place) { return yours[static_cast<std::size_t>(place - right.begin())]; };
    const double factor = (at(high) - at(low)) / (*high - *low);
    const double offset = at(high) - factor * *high;
    const double size = std::max(std::abs(*low), std::abs(*high)) * std::max(1.0, std::abs(factor)) + std::abs(offset);
    for (std::size_t i = 0; i < right.size(); ++i)
        if (std::abs(factor * right[i] + offset - yours[i]) > rounding * size) return std::nullopt;
    if (is_same_number(factor, 1) || std::abs(factor) < 100 * rounding || std::abs(offset) < 100 * rounding * size)
        return std::nullopt;
    if (is_same_number(factor, -1)) return constant_text(offset, false) + " minus the right one";
    return fmt::format("{} times the right one {} {}", constant_text(factor), offset > 0 ? "plus" : "minus",
                       constant_text(std::abs(offset), false));
}

/// "times the length of normal", "divided by the square of ray.t_max": how each of these factors follows from its
/// question.
std::optional<std::string> as_factor(std::span<const double> factors, std::span<const std::size_t> questions,
                                     const std::vector<Fact>& facts)
{
    if (std::ranges::any_of(factors, [](double x) { return x == 0 || !std::isfinite(x); })) return std::nullopt;
    if (const auto words = told_as(factors, questions, facts)) return "times " + *words;
    std::vector<double> inverse;
    for (const double factor : factors) inverse.push_back(1 / factor);
    if (const auto words = told_as(inverse, questions, facts)) return "divided by " + *words;
    const auto roots = [](std::span<const double> squares) {
        std::vector<double> found;
        for (const double square : squares) found.push_back(std::sqrt(square));
        return found;
    };
    if (const auto words = told_as(roots(factors), questions, facts)) return "times the square of " + *words;
    if (const auto words = told_as(roots(inverse), questions, facts)) return "divided by the square of " + *words;
    if (const auto words = told_as_quotient(factors, questions, facts)) return "times " + *words;
    return std::nullopt;
}

/// A vector that stands in the question, or its opposite.
std::optional<std::string> argument(const WrongVectors& vectors, const std::vector<Fact>& facts)
{
    std::vector<std::string> words;
    for (const Fact& fact : facts) words.push_back(fact.words);
    for (const auto& [name, first, size] : vectors_in(words)) {
        if (facts[first].answer || size < vectors.components) continue;
        bool equal = true;
        bool opposite = true;
        std::set<std::vector<double>> different;
        for (std::size_t i = 0; i < vectors.yours.size(); ++i) {
            std::vector<double> value;
            for (std::size_t c = 0; c < vectors.components; ++c)
                value.push_back(facts[first + c].values.at(vectors.questions[i]));
            equal = equal && alike_vectors(vectors.yours[i], value);
            std::vector<double> other(value.size());
            std::ranges::transform(value, other.begin(), std::negate{});
            opposite = opposite && alike_vectors(vectors.yours[i], other);
            different.insert(value);
        }
        if (different.size() < least_different || (!equal && !opposite)) continue;
        // A name alone would be read as what the answer is.
        const std::string given = name.find('.') == std::string::npos ? "the given " + name : name;
        return equal ? "is " + given : fmt::format("is {} with the opposite sign", given);
    }
    return std::nullopt;
}

/// A vector of the question that is missing in what is answered, or that was added to it.
std::optional<std::string> lacking(const WrongVectors& vectors, const std::vector<Fact>& facts)
{
    std::vector<std::string> words;
    for (const Fact& fact : facts) words.push_back(fact.words);
    for (const auto& [name, first, size] : vectors_in(words)) {
        if (facts[first].answer || size != vectors.components) continue;
        bool lacks = true;
        bool has = true;
        std::set<std::vector<double>> different;
        for (std::size_t i = 0; i < vectors.yours.size() && (lacks || has); ++i) {
            std::vector<double> value;
            for (std::size_t c = 0; c < size; ++c) value.push_back(facts[first + c].values.at(vectors.questions[i]));
            const double tolerance = rounding * length_of(value) +
                                     of_floats * std::max(length_of(vectors.yours[i]), length_of(vectors.right[i]));
            const auto is_added = [&](double sign) {
                for (std::size_t c = 0; c < size; ++c)
                    if (!(std::abs(vectors.yours[i][c] - vectors.right[i][c] - sign * value[c]) <= tolerance))
                        return false;
                return true;
            };
            lacks = lacks && is_added(-1);
            has = has && is_added(1);
            if (length_of(value) > 100 * tolerance) different.insert(std::move(value));
        }
        if (different.size() >= least_different && lacks != has)
            return lacks ? "lacks " + name : fmt::format("has {} too much", name);
    }
    return std::nullopt;
}

/// How many times the right vector each of these is; nothing if one is no multiple of it.
std::optional<std::vector<double>> factors_of(const WrongVectors& vectors)
{
    std::vector<double> factors;
    for (std::size_t i = 0; i < vectors.yours.size(); ++i) {
        const auto yours = vectors.yours[i];
        const auto right = vectors.right[i];
        const double square = std::inner_product(right.begin(), right.end(), right.begin(), 0.0);
        const double factor = std::inner_product(right.begin(), right.end(), yours.begin(), 0.0) / square;
        if (!(square > 0) || factor == 0) return std::nullopt;
        std::vector<double> multiple;
        for (const double x : right) multiple.push_back(factor * x);
        if (!alike_vectors(yours, multiple)) return std::nullopt;
        factors.push_back(factor);
    }
    return factors;
}

/// Are the numbers x, y and z of something, or have they no names at all? Counts and states have no direction.
bool are_coordinates(const std::vector<std::string>& names)
{
    return std::ranges::all_of(names, [](const std::string& name) {
        return name.size() <= 1 || name[name.size() - 2] == '.' || name.ends_with(']');
    });
}

std::optional<AnswerPattern> multiple_of(const WrongVectors& vectors, const std::vector<Fact>& facts)
{
    const auto factors = factors_of(vectors);
    // Along one axis anything is a multiple.
    const bool oblique = std::ranges::count_if(vectors.right, [](std::span<const double> right) {
                             return std::ranges::count_if(right, [](double x) { return x != 0; }) > 1;
                         }) >= static_cast<std::ptrdiff_t>(least_different);
    if (!factors || !oblique) return std::nullopt;
    // What is off by a rounding is no multiple of it.
    if (std::ranges::all_of(*factors, [](double factor) { return is_same_number(factor, 1); })) return std::nullopt;
    const auto as_first = [&](double factor) { return is_same_number(factor, factors->front()); };
    if (std::ranges::all_of(*factors, as_first)) {
        AnswerPattern found = multiple(factors->front());
        found.words.insert(0, "is ");
        return found;
    }
    if (const auto words = as_factor(*factors, vectors.questions, facts))
        return AnswerPattern{"is the right one " + *words};
    if (!are_coordinates(vectors.names)) return std::nullopt;
    if (std::ranges::all_of(*factors, [](double factor) { return factor > 0; }))
        return AnswerPattern{"has the right direction, but not the right length"};
    if (vectors.components > 1 && are_varied(*factors))
        return AnswerPattern{"lies along the right one, with another length, and not always to the same side"};
    return std::nullopt;
}

/// The same numbers in other places, or with other signs.
std::optional<std::string> rearranged(const WrongVectors& vectors)
{
    if (vectors.names.size() != vectors.components) return std::nullopt;
    std::vector<std::string> names;
    std::vector<std::string> moved;
    bool in_place = true;
    bool any_opposite = false;
    for (std::size_t to = 0; to < vectors.components; ++to) {
        const auto holds = [&](std::size_t from, double sign) {
            for (std::size_t i = 0; i < vectors.yours.size(); ++i)
                if (std::abs(vectors.yours[i][to] - sign * vectors.right[i][from]) >
                    rounding * length_of(vectors.right[i]))
                    return false;
            std::set<double> values;
            for (const auto right : vectors.right) values.insert(right[from]);
            return values.size() >= least_different || from == to;
        };
        // Its own place first.
        std::vector<std::size_t> order{to};
        for (std::size_t from = 0; from < vectors.components; ++from)
            if (from != to) order.push_back(from);
        const auto from = std::ranges::find_if(order, [&](std::size_t i) { return holds(i, 1) || holds(i, -1); });
        if (from == order.end()) return std::nullopt;
        const bool plus = holds(*from, 1);
        in_place = in_place && *from == to && plus;
        any_opposite = any_opposite || !plus;
        if (*from != to) moved.push_back(vectors.names.at(*from));
        names.push_back((plus ? "" : "-") + vectors.names.at(*from));
    }
    if (in_place) return std::nullopt;
    if (moved.size() == 2 && !any_opposite)
        return fmt::format("is the right one with {} and {} exchanged", moved.back(), moved.front());
    return fmt::format("is ({}) of the right one", fmt::join(names, ", "));
}

}

std::optional<std::string> relation_of(const WrongNumbers& numbers, const std::vector<Fact>& facts)
{
    if (numbers.yours.empty()) return std::nullopt;
    if (auto words = told_as(numbers.yours, numbers.questions, facts)) {
        // A name alone would be read as what the answer is.
        const bool is_name = words->find_first_of(". ") == std::string::npos;
        return is_name ? "the given " + *words : *words;
    }
    if (auto words = told_as_either(numbers.yours, numbers.questions, facts)) return words;
    const std::vector<double> more = made_of(numbers.yours, numbers.right, std::minus{});
    if (const auto words = told_as(more, numbers.questions, facts)) return "the right one plus " + *words;
    const std::vector<double> less = made_of(numbers.right, numbers.yours, std::minus{});
    if (const auto words = told_as(less, numbers.questions, facts)) return "the right one minus " + *words;
    if (const auto words = as_factor(made_of(numbers.yours, numbers.right, std::divides{}), numbers.questions, facts))
        return "the right one " + *words;
    return linear(numbers.yours, numbers.right);
}

std::optional<AnswerPattern> relation_of(const WrongVectors& vectors, const std::vector<Fact>& facts)
{
    if (vectors.yours.empty()) return std::nullopt;
    auto words = argument(vectors, facts);
    if (!words)
        if (auto found = multiple_of(vectors, facts)) return found;
    if (!words) words = lacking(vectors, facts);
    if (!words) words = rearranged(vectors);
    return words ? std::optional(AnswerPattern{*std::move(words)}) : std::nullopt;
}

std::optional<int> sign_between(std::span<const double> yours, std::span<const double> others)
{
    if (yours.size() != others.size() || !are_varied(others)) return std::nullopt;
    if (are_same_numbers(yours, others)) return 1;
    if (std::ranges::equal(yours, others, [](double a, double b) { return is_same_number(a, -b); })) return -1;
    return std::nullopt;
}

std::optional<int> sign_between(const std::vector<std::span<const double>>& yours,
                                const std::vector<std::span<const double>>& others)
{
    std::set<std::vector<double>> different;
    for (const auto other : others) different.emplace(other.begin(), other.end());
    if (yours.size() != others.size() || different.size() < least_different) return std::nullopt;
    const auto opposite = [](std::span<const double> a, std::span<const double> b) {
        std::vector<double> negated(b.size());
        std::ranges::transform(b, negated.begin(), std::negate{});
        return alike_vectors(a, negated);
    };
    if (std::ranges::equal(yours, others, alike_vectors)) return 1;
    if (std::ranges::equal(yours, others, opposite)) return -1;
    return std::nullopt;
}

}
