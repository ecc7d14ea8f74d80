#pragma once

#include <array>
#include <glm/glm.hpp>
#include <umbral/pipeline/clip.hpp>
#include <vector>

namespace umbral::render {

/// A vertex between the vertex stage and the division by w.
struct ClipVertex {
    glm::vec4 clip;
    glm::vec3 eye;     ///< position in eye space
    glm::vec3 normal;  ///< in eye space
    glm::vec2 uv;
};

/// The planes beyond which a vertex lies, as bits of pipeline::outside_planes, where the sides are those of the guard
/// band: |x| <= guard.x w, |y| <= guard.y w. `guard` has powers of two.
[[nodiscard]] inline unsigned outcode(const glm::vec4& clip, const glm::vec2& guard)
{
    return pipeline::outside_planes({clip.x / guard.x, clip.y / guard.y, clip.z, clip.w});
}

/// The part of a triangle inside |x| <= guard.x w, |y| <= guard.y w, -w <= z <= w as a convex polygon, by the unit
/// pipeline/clip-homogeneous: positions, and the weights of the triangle's corners in each.
void clip_positions(const std::array<glm::vec4, 3>& triangle, const glm::vec2& guard,
                    std::vector<pipeline::ClipVertex>& polygon);

/// Appends the part of a triangle inside |x| <= guard.x w, |y| <= guard.y w, -w <= z <= w as a convex polygon:
/// positions by the unit pipeline/clip-homogeneous, attributes by its weights. `corners` is room to work in.
void clip_triangle(const std::array<ClipVertex, 3>& triangle, const glm::vec2& guard,
                   std::vector<pipeline::ClipVertex>& corners, std::vector<ClipVertex>& polygon);

}
