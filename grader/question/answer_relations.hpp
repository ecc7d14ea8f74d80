#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "question/answer_pattern.hpp"
#include "question/facts.hpp"

namespace umbral::grader {

/// A number that is wrong in several answers, beside the right ones and what is told of the questions.
struct WrongNumbers {
    std::vector<double> yours;
    std::vector<double> right;
    /// For each of them, which question it answers: its place in the values of the facts.
    std::vector<std::size_t> questions;
};

/// What each of these numbers is, in words that follow "which is": "ray.t_min", "the right one plus ray.t_min", "0.5
/// times the right one plus 1". Nothing if no such words hold for all of them, or if too few differ for them to say
/// anything.
[[nodiscard]] std::optional<std::string> relation_of(const WrongNumbers& numbers, const std::vector<Fact>& facts);

/// A vector that is wrong in several answers: `yours` and `right` hold `components` numbers of each.
struct WrongVectors {
    std::size_t components = 3;
    std::vector<std::string> names;  ///< what the numbers are called; none if they have no names
    std::vector<std::span<const double>> yours;
    std::vector<std::span<const double>> right;
    std::vector<std::size_t> questions;
};

/// 1 if all of `yours` are the numbers of `others` in the same places, -1 if they are all opposite; nothing if neither
/// is so, or if too few differ.
[[nodiscard]] std::optional<int> sign_between(std::span<const double> yours, std::span<const double> others);
/// The same of vectors.
[[nodiscard]] std::optional<int> sign_between(const std::vector<std::span<const double>>& yours,
                                              const std::vector<std::span<const double>>& others);

/// What each of these vectors is, in words that follow "every wrong answer": "is ray.origin", "is the right one times
/// the length of normal", "lacks emission", "has the right direction, but not the right length", "is (y, x, z) of the
/// right one".
[[nodiscard]] std::optional<AnswerPattern> relation_of(const WrongVectors& vectors, const std::vector<Fact>& facts);

}
