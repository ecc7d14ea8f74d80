#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "question/facts.hpp"

namespace umbral::grader {

/// Equal, but for rounding.
[[nodiscard]] bool is_same_number(double a, double b);

/// As many, each equal to the one in its place.
[[nodiscard]] bool are_same_numbers(std::span<const double> a, std::span<const double> b);

/// Of fewer different numbers anything is true by chance.
inline constexpr std::size_t least_different = 4;

/// Are there so many?
[[nodiscard]] bool are_varied(std::span<const double> values);

/// The words of the first number told of the questions that has these values, one for each of `questions` (places in
/// the values of facts), and of others that do: "ray.t_min (here the same as ray.t_max)". Nothing if these are many.
/// Not of what is told of right answers, which are compared themselves.
[[nodiscard]] std::optional<std::string> told_as(std::span<const double> values, std::span<const std::size_t> questions,
                                                 const std::vector<Fact>& facts);

/// "texture.width / texture.height": the quotient of two numbers of one struct, or of two that are in none, that has
/// these values. Nothing if there is none, or several.
[[nodiscard]] std::optional<std::string> told_as_quotient(std::span<const double> values,
                                                          std::span<const std::size_t> questions,
                                                          const std::vector<Fact>& facts);

/// "ray.t_min or ray.t_max": two numbers of the questions of which each value is one, as where the ends of an interval
/// are taken in. Each must be it several times.
[[nodiscard]] std::optional<std::string> told_as_either(std::span<const double> values,
                                                        std::span<const std::size_t> questions,
                                                        const std::vector<Fact>& facts);

}
