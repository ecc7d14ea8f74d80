#include "question/told_as.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "question/alike.hpp"
#include "question/names.hpp"

namespace umbral::grader {
namespace {

/// What is told of each of these questions.
std::vector<double> told_values(const Fact& fact, std::span<const std::size_t> questions)
{
    std::vector<double> values;
    for (const std::size_t question : questions) values.push_back(fact.values.at(question));
    return values;
}

/// Is each of `values` the quotient of these two, but for rounding? Of a difference of nearly equal numbers little is
/// left that is exact: few may be a little off.
bool are_quotients(std::span<const double> values, const std::vector<double>& above, const std::vector<double>& below)
{
    constexpr double a_little = 0.05;
    constexpr std::size_t least_quotients = 3;
    std::set<double> quotients;
    std::size_t off = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double quotient = above[i] / below[i];
        if (!alike(values[i], quotient, std::abs(quotient)) && ++off * 5 > values.size()) return false;
        if (!(std::abs(values[i] - quotient) <= a_little * std::abs(quotient))) return false;
        quotients.insert(quotient);
    }
    return quotients.size() >= least_quotients;
}

}

bool is_same_number(double a, double b) { return alike(a, b, std::max(std::abs(a), std::abs(b))); }

bool are_same_numbers(std::span<const double> a, std::span<const double> b)
{
    return std::ranges::equal(a, b, is_same_number);
}

bool are_varied(std::span<const double> values)
{
    return std::set<double>(values.begin(), values.end()).size() >= least_different;
}

std::optional<std::string> told_as(std::span<const double> values, std::span<const std::size_t> questions,
                                   const std::vector<Fact>& facts)
{
    constexpr std::size_t most_others = 2;
    if (!are_varied(values)) return std::nullopt;
    std::optional<std::string> words;
    std::vector<std::string> others;
    for (const Fact& fact : facts) {
        if (fact.answer || fact.kind == Fact::Kind::parallel || !are_same_numbers(told_values(fact, questions), values))
            continue;
        if (!words)
            words = fact.words;
        else if (fact.kind == Fact::Kind::number || fact.kind == Fact::Kind::length)
            others.push_back(fact.words);
    }
    if (others.empty()) return words;
    if (others.size() > most_others) return std::nullopt;
    return fmt::format("{} (here the same as {})", *words, fmt::join(others, " and "));
}

std::optional<std::string> told_as_quotient(std::span<const double> values, std::span<const std::size_t> questions,
                                            const std::vector<Fact>& facts)
{
    const auto is_usable = [](const Fact& fact) { return fact.kind == Fact::Kind::number && !fact.answer; };
    std::vector<std::pair<const Fact*, std::vector<double>>> told;
    for (const Fact& fact : facts)
        if (is_usable(fact)) told.emplace_back(&fact, told_values(fact, questions));
    std::optional<std::string> words;
    for (const auto& [above, dividends] : told)
        for (const auto& [below, divisors] : told) {
            if (above == below || owner_of(above->words) != owner_of(below->words)) continue;
            if (!are_quotients(values, dividends, divisors)) continue;
            if (words) return std::nullopt;
            words = fmt::format("{} / {}", above->words, below->words);
        }
    return words;
}

std::optional<std::string> told_as_either(std::span<const double> values, std::span<const std::size_t> questions,
                                          const std::vector<Fact>& facts)
{
    constexpr std::size_t least_each = 3;
    if (!are_varied(values)) return std::nullopt;
    struct Met {
        const Fact* fact;
        std::vector<bool> here{};
        std::set<double> different{};
    };
    std::vector<Met> met;
    for (const Fact& fact : facts) {
        if (fact.answer || fact.kind != Fact::Kind::number || !fact.value_names.empty()) continue;
        Met one{&fact};
        const std::vector<double> told = told_values(fact, questions);
        for (std::size_t i = 0; i < values.size(); ++i) {
            one.here.push_back(is_same_number(told[i], values[i]));
            if (one.here.back()) one.different.insert(values[i]);
        }
        if (one.different.size() >= least_each) met.push_back(std::move(one));
    }
    for (std::size_t a = 0; a < met.size(); ++a)
        for (std::size_t b = a + 1; b < met.size(); ++b) {
            bool covers = true;
            for (std::size_t i = 0; i < values.size() && covers; ++i) covers = met[a].here[i] || met[b].here[i];
            if (covers) return fmt::format("{} or {}", met[a].fact->words, met[b].fact->words);
        }
    return std::nullopt;
}

}
