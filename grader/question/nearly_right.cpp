#include "question/nearly_right.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "question/alike.hpp"

namespace umbral::grader {
namespace {

constexpr double little = 0.01;
constexpr double in_rounding = 1e-5;
constexpr double most_of_float = 1e-6;  ///< what a few steps in float lose
constexpr double least_of_float = 3e-9;

bool is_whole(double x) { return x == std::round(x); }

/// How many numbers of a row are of one size: those of a vector or of a matrix's column. Other rows hold different
/// things, beside which nothing may be called little.
std::size_t numbers_of_one_size(const AnswerTable& table)
{
    if (table.keys > 0) return 1;
    if (table.components <= 4) return table.components;
    return table.components == 16 ? 4 : table.components == 9 ? 3 : 1;
}

bool is_nearly_right(const AnswerPair& one, std::size_t together, double part = little)
{
    if (one.yours.size() != one.expected.size()) return false;
    const std::span<const double> expected(one.expected);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const std::size_t first = i - i % together;
        const double most = part * size_of(expected.subspan(first, std::min(together, expected.size() - first)));
        if (!(std::abs(one.yours[i] - expected[i]) <= most)) return false;
    }
    return true;
}

/// Are all numbers that differ whole, as codes and counts are?
bool differ_in_whole_ones(const AnswerPair& one)
{
    for (std::size_t i = 0; i < std::min(one.yours.size(), one.expected.size()); ++i)
        if (one.yours[i] != one.expected[i] && !(is_whole(one.yours[i]) && is_whole(one.expected[i]))) return false;
    return true;
}

/// How many are so; none where all that differs is whole.
std::size_t nearly_right_in(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong, double part = little)
{
    if (std::ranges::all_of(wrong, [](const AnswerPair* one) { return differ_in_whole_ones(*one); })) return 0;
    const std::size_t together = numbers_of_one_size(table);
    return static_cast<std::size_t>(
        std::ranges::count_if(wrong, [&](const AnswerPair* one) { return is_nearly_right(*one, together, part); }));
}

}

const char* nearly_right(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong)
{
    if (wrong.empty() || nearly_right_in(table, wrong) != wrong.size()) return nullptr;
    if (nearly_right_in(table, wrong, in_rounding) != wrong.size()) return roughly_right;
    // Some of many numbers are near a float by chance.
    const bool lose_no_more = nearly_right_in(table, wrong, most_of_float) == wrong.size();
    const bool lose_as_much = 2 * nearly_right_in(table, wrong, least_of_float) <= wrong.size();
    return lose_no_more && lose_as_much ? right_to_float : right_but_for_rounding;
}

bool are_mostly_nearly_right(const AnswerTable& table, const std::vector<const AnswerPair*>& wrong)
{
    constexpr std::size_t least_answers = 8;
    return wrong.size() >= least_answers && 3 * nearly_right_in(table, wrong) >= 2 * wrong.size();
}

}
