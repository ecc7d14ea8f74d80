#include "question/distance_relation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "question/alike.hpp"
#include "question/number_changes.hpp"

namespace umbral::grader {
namespace {

/// Of fewer different numbers anything is true by chance.
constexpr std::size_t least_distances = 4;
constexpr double most_factor = 16;  ///< nobody multiplies by more without another reason that would be told

/// Numbers beside each other: `yours` is a constant times `right`, but for the rounding of what each was made of.
struct Multiples {
    std::vector<double> yours;
    std::vector<double> right;
    std::vector<double> rounded;

    void add(double mine, double theirs, double size)
    {
        yours.push_back(mine);
        right.push_back(theirs);
        rounded.push_back(of_floats * size);
    }

    /// Nothing if it is none, or 0 or 1, or if too few differ.
    [[nodiscard]] std::optional<double> factor() const
    {
        std::size_t largest = 0;
        std::set<double> different;
        for (std::size_t i = 0; i < right.size(); ++i) {
            if (!std::isfinite(yours[i]) || !std::isfinite(right[i])) return std::nullopt;
            if (std::abs(right[i]) > std::abs(right[largest])) largest = i;
            if (std::abs(right[i]) > 100 * rounded[i]) different.insert(right[i]);
        }
        if (different.size() < least_distances) return std::nullopt;
        double found = yours[largest] / right[largest];
        // Of a whole number or a half it is that, and not what roundings make of it.
        if (const double simple = std::round(2 * found) / 2; std::abs(found - simple) < rounding) found = simple;
        for (std::size_t i = 0; i < right.size(); ++i)
            if (!(std::abs(yours[i] - found * right[i]) <= (1 + std::abs(found)) * rounded[i])) return std::nullopt;
        const bool says_nothing =
            std::abs(found) < 1.0 / most_factor || std::abs(found) > most_factor || std::abs(found - 1) < 1e-3;
        return says_nothing ? std::nullopt : std::optional(found);
    }
};

bool may_be_compared(const Fact& fact)
{
    return !fact.answer && fact.kind == Fact::Kind::number && fact.value_names.empty();
}

void add_distances(const WrongNumbers& numbers, const Fact& from, Multiples& all)
{
    for (std::size_t i = 0; i < numbers.yours.size(); ++i) {
        const double origin = from.values.at(numbers.questions[i]);
        all.add(numbers.yours[i] - origin, numbers.right[i] - origin,
                std::max({std::abs(numbers.yours[i]), std::abs(numbers.right[i]), std::abs(origin)}));
    }
}

/// A fact that is 0 everywhere makes a multiple of the right number, which is told otherwise.
bool is_ever_not_zero(const WrongNumbers& numbers, const Fact& fact)
{
    return std::ranges::any_of(numbers.questions, [&](std::size_t i) { return fact.values.at(i) != 0; });
}

std::string words_of(double factor, const std::string& from)
{
    const std::string times = factor == -1 ? "" : constant_text(std::abs(factor), false) + " times ";
    return fmt::format("{}as far from {} as the right one{}", times, from, factor < 0 ? ", on the other side" : "");
}

/// The numbers of an argument that are called as the columns are, in their order; empty if it lacks one.
std::vector<const Fact*> called_alike(const std::string& owner, const std::vector<std::string>& names,
                                      const std::vector<Fact>& facts)
{
    std::vector<const Fact*> found;
    for (const std::string& name : names) {
        const auto fact = std::ranges::find(facts, owner + "." + name, &Fact::words);
        if (fact == facts.end() || !may_be_compared(*fact)) return {};
        found.push_back(&*fact);
    }
    return found;
}

/// "box" for each "box.low.y" of a column "low.y".
std::set<std::string> owners_of(const std::string& name, const std::vector<Fact>& facts)
{
    std::set<std::string> owners;
    for (const Fact& fact : facts)
        if (fact.words.size() > name.size() + 1 && fact.words.ends_with("." + name))
            owners.insert(fact.words.substr(0, fact.words.size() - name.size() - 1));
    return owners;
}

}

std::optional<std::string> distance_relation(const std::vector<WrongNumbers>& columns,
                                             const std::vector<std::string>& names, const std::vector<Fact>& facts)
{
    if (columns.empty() || columns.front().questions.empty()) return std::nullopt;
    if (names.empty()) {
        for (const Fact& fact : facts) {
            if (!may_be_compared(fact) || !is_ever_not_zero(columns.front(), fact)) continue;
            Multiples all;
            add_distances(columns.front(), fact, all);
            if (const auto factor = all.factor()) return words_of(*factor, fact.words);
        }
        return std::nullopt;
    }
    for (const std::string& owner : owners_of(names.front(), facts)) {
        const std::vector<const Fact*> from = called_alike(owner, names, facts);
        Multiples all;
        bool is_moved = false;
        for (std::size_t i = 0; i < from.size(); ++i) {
            add_distances(columns[i], *from[i], all);
            is_moved = is_moved || is_ever_not_zero(columns[i], *from[i]);
        }
        if (!is_moved) continue;
        if (const auto factor = all.factor()) return words_of(*factor, owner);
    }
    return std::nullopt;
}

std::optional<std::string> difference_relation(const WrongNumbers& numbers, const std::vector<Fact>& facts)
{
    for (const Fact& fact : facts) {
        if (!may_be_compared(fact)) continue;
        Multiples all;
        for (std::size_t i = 0; i < numbers.yours.size(); ++i) {
            const double value = fact.values.at(numbers.questions[i]);
            all.add(numbers.yours[i] - numbers.right[i], value,
                    std::max({std::abs(numbers.yours[i]), std::abs(numbers.right[i]), std::abs(value)}));
        }
        if (const auto factor = all.factor())
            return fmt::format("the right one {} {} times {}", *factor > 0 ? "plus" : "minus",
                               constant_text(std::abs(*factor), false), fact.words);
    }
    return std::nullopt;
}

}
