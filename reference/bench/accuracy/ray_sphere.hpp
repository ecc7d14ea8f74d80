#pragma once

#include <umbral/core/random.hpp>
#include <vector>

#include "solutions.hpp"

namespace umbral::bench {

struct Shot {
    Ray ray;
    raytracing::Sphere sphere;
};

/// `count` rays of unit direction from `distance` radii away (> 1.3), aimed uniformly at a disc of 1.3 radii across the
/// sphere's centre; radii in [0.5, 2), centres within 1 of the world's along each axis.
[[nodiscard]] std::vector<Shot> shots_from(double distance, int count, Random& random);

/// How far a variant lies from the truth.
struct ShotErrors {
    double p95 = 0;         ///< 95th percentile of the error of t where both hit, in ulp
    double worst = 0;       ///< the largest one
    double wrong_hits = 0;  ///< share of rays that hit for miss, or miss for hit, in percent
};

[[nodiscard]] ShotErrors errors_of(Intersect* variant, const std::vector<Shot>& shots);

}
