#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>

#include "model.hpp"

namespace umbral::bench::scenes {

/// A surface over the unit square, columns x rows cells of two triangles; normals by differences, pointing to where
/// `at` turns counter-clockwise. Cells that degenerate to a triangle, as at poles, give one only.
[[nodiscard]] Triangles surface(int columns, int rows, const std::function<glm::vec3(glm::vec2)>& at);

/// The unit sphere.
[[nodiscard]] Triangles ball(int sectors, int rings);
/// Radius 1 round the y axis, and that of the tube.
[[nodiscard]] Triangles torus(float tube, int sectors, int sides);
/// A tube along the (2, 3) torus knot.
[[nodiscard]] Triangles knot(float tube, int sectors, int sides);
/// (radius, height) from below upwards, turned round the y axis.
[[nodiscard]] Triangles lathe(std::span<const glm::vec2> profile, int sectors);
/// A vase of radius about 1, from y = -1 to 1.
[[nodiscard]] Triangles vase(int sectors);
/// From -half to half.
[[nodiscard]] Triangles box(const glm::vec3& half);
/// The square from (-1, -1, 0) to (1, 1, 0), facing +z; u along x, v along y.
[[nodiscard]] Triangles square(int cells = 1);
/// The square from -1 to 1 in x and z, facing +y; u along x, v along -z.
[[nodiscard]] Triangles ground(int cells = 1);
/// A sphere of triangles, each with a normal of its own; `rounds` of cutting an icosahedron's triangles into four.
[[nodiscard]] Triangles gem(int rounds);

/// A line as two triangles in the plane facing +z, so many units wide.
void add_stroke(Triangles& strokes, const glm::vec2& from, const glm::vec2& to, float width, const glm::vec4& color);

/// The edges of a mesh as pairs of corners, each once.
[[nodiscard]] Triangles edges_of(const Triangles& mesh);

void paint(Triangles& mesh, const std::function<glm::vec4(const Vertex&)>& color);
[[nodiscard]] Triangles joined(std::initializer_list<Triangles> parts);
/// The mesh moved: positions by the matrix, normals by its inverse transpose.
[[nodiscard]] Triangles moved(Triangles mesh, const glm::mat4& by);

}
