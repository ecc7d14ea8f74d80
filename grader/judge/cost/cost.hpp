#pragma once

#include <optional>
#include <string>
#include <umbral/record/tensor.hpp>
#include <vector>

namespace umbral::grader {

/// What only this judge takes.
struct CostParameters {
    double growth = 1;    ///< the largest exponent of the size with which the count may grow
    std::string after{};  ///< another table of the case whose work on a size this one's needs; or none
};

/// What one size took, in basic blocks.
struct CostRow {
    double size = 0;
    double blocks = 0;
};
using Cost = std::vector<CostRow>;

/// The rows of a table that record_cost made; nothing for a tensor of another type or shape.
[[nodiscard]] std::optional<Cost> cost_of(const Tensor& tensor);

/// The exponent with which the count grows: the slope of the straight line through (log size, log blocks) with the
/// least squares. Needs two sizes at least, and everything positive.
[[nodiscard]] double growth_of(const Cost& cost);

/// The growth of counts that can be compared with the expected ones: the same sizes, and work done for each.
[[nodiscard]] std::optional<double> comparable_growth(const Tensor& tensor, const Tensor& expected);

}
