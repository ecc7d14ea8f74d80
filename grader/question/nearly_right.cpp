#include "question/nearly_right.hpp"

#include <algorithm>
#include <cmath>

#include "question/alike.hpp"

namespace umbral::grader {
namespace {

constexpr double little = 0.01;

bool is_whole(double x) { return x == std::round(x); }

bool is_nearly_right(const AnswerPair& one)
{
    const double most = little * size_of(one.expected);
    return std::ranges::equal(one.yours, one.expected,
                              [most](double yours, double right) { return std::abs(yours - right) <= most; });
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
