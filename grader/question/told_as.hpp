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

/// Are there so many different ones that what is true of all is no chance?
[[nodiscard]] bool are_varied(std::span<const double> values);

/// The words of the first number told of the questions that has these values, one for each of `questions` (places in
/// the values of facts), and of others that do: "ray.t_min (here the same as ray.t_max)". Nothing if these are many.
/// Not of what is told of right answers, which are compared themselves.
[[nodiscard]] std::optional<std::string> told_as(std::span<const double> values, std::span<const std::size_t> questions,
                                                 const std::vector<Fact>& facts);

/// "ray.t_min or ray.t_max": two numbers of the questions of which each value is one, as where the ends of an interval
/// are taken in. Each must be it several times.
[[nodiscard]] std::optional<std::string> told_as_either(std::span<const double> values,
                                                        std::span<const std::size_t> questions,
                                                        const std::vector<Fact>& facts);

}
