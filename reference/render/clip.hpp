#pragma once

#include <array>
#include <glm/glm.hpp>

namespace umbral::render {

/// A vertex between the vertex stage and the division by w.
struct ClipVertex {
    glm::vec4 clip;
    glm::vec3 eye;     ///< position in eye space
    glm::vec3 normal;  ///< in eye space
    glm::vec2 uv;
};

/// A convex polygon: three corners, and at most one more for each of six planes. Rounding may make a sliver not quite convex; there is room
/// for that, and no more: add() drops what does not fit.
struct ClipPolygon {
    std::array<ClipVertex, 12> corners;
    std::size_t size = 0;

    void add(const ClipVertex& corner)
    {
        if (size < corners.size()) corners[size++] = corner;
    }
};

/// The planes beyond which a vertex lies, as bits: left, right, below, above (of the guard band), near, far.
[[nodiscard]] unsigned outcode(const glm::vec4& clip, const glm::vec2& guard);

/// The part of a triangle inside |x| <= guard.x w, |y| <= guard.y w, -w <= z <= w. `planes` says which planes to cut at: the union of the
/// corners' outcodes. Attributes are linear in clip space, so they are cut with it. A cut is computed from the inner end to the outer one,
/// so that triangles that share an edge get the same new vertex.
/// Based on: I. Sutherland, G. Hodgman. Reentrant Polygon Clipping. 1974, in homogeneous coordinates.
[[nodiscard]] ClipPolygon clip_triangle(const std::array<ClipVertex, 3>& triangle, unsigned planes, const glm::vec2& guard);

}
