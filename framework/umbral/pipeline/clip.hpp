#pragma once

#include <array>
#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::pipeline {

/// A corner of what is left of a triangle.
struct ClipVertex {
    glm::vec4 position;  ///< in clip coordinates
    glm::vec3 weights;  ///< of the triangle's corners: an attribute is weights[0] * a0 + weights[1] * a1 + weights[2] *
                        ///< a2; they sum to 1
};

/// The sides of the view volume beyond which a point in clip coordinates lies, as bits 0 to 5: left (x < -w), right (x
/// > w), below, above, near (z < -w), far. Bit 6 is set unless w > 0. All bits are set where x, y, z and w are NaN;
/// comparisons are exact.
///
/// A triangle whose corners all have 0 needs no clipping; one whose corners share a bit is outside.
[[nodiscard]] inline unsigned outside_planes(const glm::vec4& position)
{
    const auto [x, y, z, w] = std::array{position.x, position.y, position.z, position.w};
    const auto bit = [](bool inside, unsigned plane) { return (inside ? 0U : 1U) << plane; };
    return bit(x >= -w, 0) | bit(x <= w, 1) | bit(y >= -w, 2) | bit(y <= w, 3) | bit(z >= -w, 4) | bit(z <= w, 5) |
           bit(w > 0, 6);
}

/// Appends the part of a triangle inside the view volume -w <= x, y, z <= w: the corners of a convex polygon, in order,
/// turning as the triangle does. There are 3 to 9 of them, or none where the triangle lies outside.
///
/// Clips before the division by w, so that corners may lie behind the camera (w < 0) or in its plane (w = 0). The
/// volume is closed: a corner on a plane stays, and so does a triangle in a plane. A triangle that only touches the
/// volume, in a corner or a side, gives nothing; neither does one with a corner in the eye (0, 0, 0, 0), nor one with a
/// number that is NaN or infinite. No corner comes twice in a row. Guarantee of the reference: all of |x|, |y|, |z| <=
/// w and w > 0 hold exactly; a new corner lies exactly on its plane; positions and weights are within 2 ulp of their
/// largest component; and two triangles that share a side get the same new corners on it, bit by bit. To clip at a
/// guard band instead, divide x and y by its factor, a power of two, and multiply the results: both are exact. Course:
/// clipping in clip coordinates, new vertices with attributes (C 1.4), S4 (which divides first: wrong where w <= 0).
void clip_triangle(const std::array<glm::vec4, 3>& triangle, std::vector<ClipVertex>& polygon);

}
