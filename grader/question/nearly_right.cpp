#include "question/nearly_right.hpp"

#include <algorithm>
#include <cmath>

namespace umbral::grader {
namespace {

constexpr double little = 0.01;

bool is_whole(double x) { return x == std::round(x); }

/// The largest number decides: beside it, the others of a row may be rounding.
bool is_nearly_right(const AnswerPair& one)
{
    double size = 0;
    double error = 0;
    for (std::size_t i = 0; i < one.expected.size(); ++i) {
        size = std::max(size, std::abs(one.expected[i]));
        error = std::max(error, std::abs(one.yours[i] - one.expected[i]));
    }
    return error <= little * size;
}

}

bool are_nearly_right(const std::vector<const AnswerPair*>& wrong)
{
    const bool whole = std::ranges::all_of(wrong, [](const AnswerPair* one) {
        return std::ranges::all_of(one->yours, is_whole) && std::ranges::all_of(one->expected, is_whole);
    });
    return !whole && std::ranges::all_of(wrong, [](const AnswerPair* one) { return is_nearly_right(*one); });
}

}
