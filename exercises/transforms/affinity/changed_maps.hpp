#pragma once

#include <algorithm>
#include <array>
#include <kit/numbers_changed.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/transforms/affinity.hpp>

#include "measured_maps.hpp"

/// What random maps are never asked: single numbers that differ from the question before, corners that coincide.
namespace umbral::transforms {

inline void record_matrix(Recorder& out, const Pairs& pairs)
{
    out.append("matrix", ask<affine_from_points>(out, pairs));
}

using Corners = std::array<glm::vec3, 4>;

/// Defects in a chain of questions in which one number changes, and of corners that coincide.
inline void record_changed(Random& random, Recorder& out, Corners corners)
{
    const auto is_near = [](const Corners& all) {
        return std::ranges::all_of(all, [](const glm::vec3& corner) { return length(corner) < 7; });
    };
    for (const Corners& changed : numbers_changed(random, corners, 12, is_near))
        out.append("defect", ask<parallelogram_defect>(out, changed));
    for (const std::size_t same : {1U, 2U, 3U}) {
        Corners two = corners;
        two[same] = two[0];
        out.append("defect", ask<parallelogram_defect>(out, two));
    }
    corners.fill(corners[0]);
    out.append("defect", ask<parallelogram_defect>(out, corners));
}

/// The same points with other images, a single other image, and the same images of other points.
inline void record_other_pairs(Random& random, Recorder& out, const std::vector<glm::vec3>& points)
{
    Pairs pairs = pairs_of(points, some_affine_map(random));
    record_matrix(out, pairs);
    pairs[random.below(4)].image += 0.5F * random.in_cube();
    record_matrix(out, pairs);
    const std::vector<glm::vec3> others = some_points(random, 0);
    for (std::size_t i = 0; i < 4; ++i) pairs[i].point = others[i];
    record_matrix(out, pairs);
}

}
