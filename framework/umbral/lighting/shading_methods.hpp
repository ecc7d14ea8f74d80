#pragma once

#include <functional>
#include <span>
#include <umbral/core/not_implemented.hpp>
#include <umbral/lighting/light.hpp>
#include <umbral/pipeline/depth.hpp>

/// Where a picture's light is computed: once for each triangle, each vertex, or each pixel.
namespace umbral::lighting {

/// A vertex that has gone through the vertex stage.
struct StagedVertex {
    pipeline::WindowVertex window;  ///< where it is seen
    SurfacePoint at;                ///< where it is in the world, and its unit normal
};

/// An illumination model with its lights, material and eye: the light that a place on a surface sends to the eye. Any
/// function; its values have no upper bound.
using Illumination = std::function<glm::vec3(const SurfacePoint&)>;

/// Draws triangles, the indices of three vertices each, in their order: each over its fragments (rasterize_triangle),
/// of which those are drawn that pass the depth test "less" against `target.depths`; they store their colour and their
/// depth. Indices are less than the number of vertices, depths lie in [0, 1], and the target's two grids have one size.
/// The three functions differ in where they ask `illumination`.
///
/// **Flat**: once for each triangle (those that draw nothing may be left out), at its last corner, with the normal of
/// the triangle itself: the unit vector along (b - a) x (c - a), whose corners in the world are a, b, c in their order.
/// The vertices' normals do not count. If the three lie on a line the normal is (0, 0, 0). All fragments get that
/// light. Guarantee of the reference: the normal within 1e-7. Course: section C 1.9, "sombreado plano".
void draw_flat(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles,
               const Illumination& illumination, pipeline::Layer& target);

/// **Gouraud**: once for each vertex as it is (those that draw nothing may be left out). A fragment gets the
/// sum of its corners' light by its weights. Course: section C 1.9, "sombreado de vértices".
void draw_gouraud(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles,
                  const Illumination& illumination, pipeline::Layer& target);

/// **Phong**: once for each fragment that passes the depth test, and for no other, at the sum of its corners' places by
/// its weights, with the sum of their normals made unit again ((0, 0, 0) if they cancel out). Guarantee of the
/// reference: the normal within 1e-7 of that of the exact sum, if the sum is longer than 1e-3. Course: section C 1.9,
/// "sombreado de píxel".
void draw_phong(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles,
                const Illumination& illumination, pipeline::Layer& target);

}
