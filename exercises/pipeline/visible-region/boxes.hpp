#pragma once

#include <cmath>
#include <kit/magnitude.hpp>
#include <kit/numbers_changed.hpp>
#include <umbral/core/random.hpp>
#include <umbral/pipeline/region.hpp>
#include <umbral/record/variation.hpp>
#include <utility>
#include <vector>

/// Boxes to show: ordinary, flat, nearly flat, mirrored, in any unit of length.
namespace umbral::pipeline {

inline constexpr Box cube = {{-1, -1, -1}, {1, 1, 1}};

/// A box that is written down, elsewhere and in other proportions: what is flat or mirrored remains so.
inline Box varied(Variation& vary, const Box& box)
{
    if (!vary) return box;
    const glm::vec3 low = vary.near(box.low, 1.0F);
    glm::vec3 size = box.high - box.low;
    for (int axis = 0; axis < 3; ++axis) size[axis] = vary.scaled(size[axis], 1.6F);
    return {low, low + size};
}

inline std::vector<Box> varied(Variation& vary, std::vector<Box> boxes)
{
    for (Box& box : boxes) box = varied(vary, box);
    return boxes;
}

inline Box random_box(Random& random, float away)
{
    Box box{away * random.in_cube(), {}};
    const float x = random.uniform(0.5F, 4);
    const float y = random.uniform(0.5F, 4);
    box.high = box.low + glm::vec3(x, y, random.uniform(0.5F, 4));
    return box;
}

/// The same box with lengths in another unit: very small, or very large.
inline Box in_unit(const Box& box, float unit) { return {unit * box.low, unit * box.high}; }

inline Box box_in_any_unit(Random& random, float away)
{
    const Box box = random_box(random, away);
    return in_unit(box, random_unit(random, -60, 60));
}

/// Flat but for a few steps of float along one axis, near the origin or far away: not flat at all.
inline Box nearly_flat(Random& random)
{
    Box box = random_box(random, random.below(2) == 0 ? 4 : 1e6F);
    const auto axis = static_cast<glm::vec3::length_type>(random.below(3));
    float& low = box.low[axis];
    if (std::abs(low) < 0.01F) low = 0.01F;
    const float step = std::nextafter(low, 1e30F) - low;
    box.high[axis] = low + static_cast<float>(1 + random.below(9)) * step;
    return in_unit(box, random_unit(random, -60, 60));
}

/// Exactly of the window's proportions, and mirrored along x, y, both or none: it is shown as it is.
inline Box fitting_box(Random& random, int width, int height)
{
    Box box{glm::vec3(glm::ivec3(8.0F * random.in_cube())), {}};
    box.high = box.low + glm::vec3(width, height, 64) / 64.0F;
    for (int axis = 0; axis < 2; ++axis)
        if (random.below(2) == 0) std::swap(box.low[axis], box.high[axis]);
    return in_unit(box, random_unit(random, -60, 60));
}

/// Boxes of 0.6 in each direction at least, mirrored ones too, and points not far from them.
inline bool is_thick(const std::pair<Box, glm::vec3>& question)
{
    const auto& [box, point] = question;
    for (int axis = 0; axis < 3; ++axis) {
        const float size = std::abs(box.high[axis] - box.low[axis]);
        if (size < 0.6F || std::abs(2 * point[axis] - box.low[axis] - box.high[axis]) > 1.5F * size) return false;
    }
    return true;
}

/// Limits that are 0, opposite or equal in two directions; each differs in one number from the one before.
inline std::vector<std::pair<Box, glm::vec3>> changed_boxes(Random& random)
{
    Box box = random_box(random, 3);
    const auto axis = static_cast<glm::length_t>(random.below(3));
    box.high[axis] = 1 + std::abs(box.low[axis]);
    if (random.below(2) == 0) box.low[axis] = -box.high[axis];
    return numbers_changed(random, std::pair(box, 0.5F * (box.low + box.high)), 5, is_thick);
}

}
