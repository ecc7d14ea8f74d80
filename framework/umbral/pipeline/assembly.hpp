#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::pipeline {

/// What a sequence of vertices stands for: GL_POINTS, GL_LINES, … GL_POLYGON.
enum class PrimitiveType {
    points,
    lines,
    line_strip,
    line_loop,
    triangles,
    triangle_strip,
    triangle_fan,
    quads,
    quad_strip,
    polygon
};

/// A point (one corner), a segment (two) or a face (three or more, in the order that goes round it).
struct Primitive {
    std::vector<std::uint32_t> corners;
    std::uint32_t provoking = 0;  ///< the vertex whose colour all of it gets in flat shading
};

/// The primitives that a sequence of n vertices stands for, in their order; `vertices` are indices, which may repeat.
///
/// n points; n/2 segments; n-1 of a strip, n of a loop; n/3 triangles; n-2 triangles of a strip or a fan; n/4 quads;
/// (n-2)/2 of a quad strip; one polygon. A loop and a polygon need three vertices. Vertices that are too many or too
/// few for one more primitive are left out. Faces of a strip all go round the same way: with s = `vertices`, triangle i
/// is (s_i, s_i+1, s_i+2), but (s_i+1, s_i, s_i+2) for odd i; quad i is (s_2i, s_2i+1, s_2i+3, s_2i+2). A fan's
/// triangles are (s_0, s_i+1, s_i+2). Degenerate ones (a vertex twice) are there as well. The provoking vertex is the
/// one of the primitive that comes last in the sequence; the first one of a polygon. That of a loop's closing segment
/// is s_0. Course: "tipos de primitivas", GL_POINTS … GL_POLYGON; it gives a fan n-1 triangles, and every primitive its
/// last vertex's colour.
[[nodiscard]] std::vector<Primitive> assemble(PrimitiveType type, std::span<const std::uint32_t> vertices);

/// Whether a face shows its front: its corners go round counter-clockwise on the screen, so that its signed area is
/// positive.
///
/// Places are in window coordinates, in pixels, x to the right and y **up**. A face without area shows its back, as in
/// OpenGL. Fewer than three corners have no area. Guarantee of the reference, for triangles within 16,384 pixels: right
/// if the coordinates are multiples of 1/1,024, or the area is more than 1e-6 pixels. Course: "cara delantera, cara
/// trasera".
[[nodiscard]] bool is_front_facing(std::span<const glm::vec2> corners);

enum class Culling { none, back, front };      ///< which faces are left out (GL_CULL_FACE)
enum class PolygonMode { point, line, fill };  ///< what is left of a face (glPolygonMode)

/// What the rasteriser is given: indices of vertices.
struct DrawList {
    std::vector<std::uint32_t> points;
    std::vector<glm::uvec2> segments;
    std::vector<glm::uvec3> triangles;
};

/// Assembles a sequence, leaves out faces by the side that they show, as is_front_facing tells it, and turns the rest
/// into what the mode asks for. `window[v]` is vertex v's place.
///
/// Points and segments are what they are, in every mode; nothing culls them. A face becomes its corners (`point`), its
/// closed outline (`line`, without diagonals), or triangles from the corner that is first in the sequence to every
/// other edge (`fill`), which go round as the face does. An edge that two faces share comes twice. Segments and
/// triangles that name a vertex twice are left out of the lists. The lists' order is free, and so is where a triangle
/// begins. Course: "cribado de caras", "modo de visualización de polígonos", "teselado".
[[nodiscard]] DrawList draw_list(PrimitiveType type, std::span<const std::uint32_t> vertices,
                                 std::span<const glm::vec2> window, Culling culling, PolygonMode mode);

}
