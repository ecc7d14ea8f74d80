#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model/exercise.hpp"

#include <umbral/record/tensor.hpp>

namespace umbral::grader {

// What controls are made of: recordings of the shape of an expected one that know nothing of the problem. See
// controls() in judge.hpp.

using Controls = std::vector<std::pair<std::string, Tensor>>;

/// Means, lows and highs of each component over the finite values of present cells.
struct ComponentStatistics {
    std::vector<double> mean;
    std::vector<double> low;
    std::vector<double> high;
};
[[nodiscard]] ComponentStatistics component_statistics(const Tensor& expected);

/// Every cell is this row.
[[nodiscard]] Tensor filled(const Tensor& expected, const std::vector<double>& row);
/// Uniform noise between the lows and highs, half of the cells absent where some may be.
[[nodiscard]] Tensor noise_within(const Tensor& expected, const ComponentStatistics& statistics, std::uint64_t seed);

/// What most judges take: zeros, ones, the identity matrix, the most frequent and the mean row, noise, all absent; of
/// pictures also the blank one, black and white.
[[nodiscard]] Controls common_controls(const Check& check, const Tensor& expected, std::uint64_t seed);

}
