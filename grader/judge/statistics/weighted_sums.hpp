#pragma once

#include <cmath>

#include "judge/statistics/stochastic.hpp"

namespace umbral::grader {

/// Sums the differences of two pictures of noise up, each times a weight of either sign that does not change if the two
/// are exchanged at that pixel: then its sign is by chance, and deviation_of() and tile_probability() hold for the sums
/// as for a tile's.
class WeightedSums {
public:
    WeightedSums(const Estimates& yours, const Estimates& expected) : yours_(yours), expected_(expected) {}

    void add(std::size_t at, double weight)
    {
        const double size = std::abs(weight);
        const double difference = yours_.values[at] - expected_.values[at];
        const double weighted = difference * weight;
        weights_ += size;
        sums_.count += 1;
        sums_.yours += std::abs(yours_.values[at]) * size;
        sums_.expected += std::abs(expected_.values[at]) * size;
        sums_.total += expected_.values[at] * weight;
        sums_.difference += weighted;
        sums_.squares += weighted * weighted;
        sums_.cubes += weighted * weighted * weighted;
        misplaced_ += std::copysign(1.0, weight) * (weight == 0 ? 0 : difference);
        if (expected_.steps.empty()) return;
        sums_.steps += expected_.steps[at] * size;
        sums_.clipped += yours_.values[at] >= 1 || expected_.values[at] >= 1 ? size : 0;
    }

    /// Divided by the mean size of the weights.
    [[nodiscard]] PatternSums result() const
    {
        PatternSums result{sums_, std::abs(misplaced_)};
        if (weights_ <= 0) return result;
        TileSums& sums = result.sums;
        const double scale = sums.count / weights_;
        for (double* sum : {&sums.yours, &sums.expected, &sums.total, &sums.difference, &sums.steps, &sums.clipped})
            *sum *= scale;
        sums.squares *= scale * scale;
        sums.cubes *= scale * scale * scale;
        return result;
    }

private:
    const Estimates& yours_;
    const Estimates& expected_;
    TileSums sums_;
    double weights_ = 0;
    double misplaced_ = 0;
};

}
