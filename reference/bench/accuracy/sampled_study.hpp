#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "samples.hpp"
#include "study.hpp"

namespace umbral::bench {

/// A way to spread points over the unit square.
struct SamplePattern {
    std::string family;  ///< "stratified"
    std::vector<glm::dvec2> (*points)(int count, Random& random);
};

[[nodiscard]] inline SamplePattern independent_pattern()
{
    return {"random", [](int count, Random& random) { return independent(count, random); }};
}

[[nodiscard]] inline SamplePattern stratified_pattern()
{
    return {"stratified", [](int count, Random& random) { return cells(count, &random); }};
}

/// What is estimated from samples.
struct SampledEstimate {
    using Points = std::function<std::vector<glm::dvec2>()>;  ///< other points with every call
    /// The error of one estimate, of something chosen by `random`.
    std::function<double(Random& random, const Points& points)> error;
    /// The estimate that is timed as number `i` of 16.
    std::function<double(int i, Random& random, const Points& points)> timed;
};

/// Adds trials of 1, 4, 16, 64 and 256 points by each pattern, with the measure "rms" over `repetitions` estimates; all
/// of them begin with the same seed.
void add_sampled_trials(Study& study, const std::vector<SamplePattern>& patterns, std::uint64_t seed, int repetitions,
                        const SampledEstimate& estimate);

}
