#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::pipeline {

/// The corners of a regular polygon, once each, for GL_LINE_LOOP (its edges) or for GL_POLYGON and GL_TRIANGLE_FAN (its
/// inside).
///
/// Centre at the origin, radius 1: corner i is (cos(2πi/n), sin(2πi/n)). So the first is (1, 0), and they go
/// counter-clockwise. The first one does not come again at the end. Fewer than three sides are no polygon: the table is
/// empty. Guarantee of the reference: every coordinate is off by less than 3.0e-8, half a unit in the last place of a
/// float below 1, for any number of sides. Course: problem 1.1 (a).
[[nodiscard]] std::vector<glm::vec2> polygon_loop(std::uint32_t sides);

/// The edges of the same polygon as pairs of corners, for GL_LINES: v_0 v_1, v_1 v_2, …, v_(n-1) v_0.
///
/// A corner is exactly the same pair of numbers wherever it stands, the last v_0 too. Empty for fewer than three sides.
/// Course: problem 1.1 (b).
[[nodiscard]] std::vector<glm::vec2> polygon_segments(std::uint32_t sides);

/// A table of vertices, and two tables of indices into it.
struct IndexedPolygon {
    std::vector<glm::vec2> positions;
    std::vector<glm::uvec3> triangles;  ///< three indices each, for GL_TRIANGLES
    std::vector<glm::uvec2> edges;      ///< two indices each, for GL_LINES
};

/// The same polygon as n equal triangles round a new vertex at its centre.
///
/// `positions` holds the n corners as in polygon_loop, and the centre, exactly (0, 0), last: n + 1 vertices.
/// `triangles` holds n of them, counter-clockwise, each of the centre and two corners that follow one another. `edges`
/// holds each edge of these triangles once: n on the rim and n to the centre. The order of triangles and of edges is
/// free, and so is the corner that a triangle begins with. All is empty for fewer than three sides. Course: problem 1.2
/// (a) and (b).
[[nodiscard]] IndexedPolygon polygon_fan(std::uint32_t sides);

}
