#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <kit/drawing.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

namespace umbral::meshes {

/// The edges as pairs with the smaller vertex first, in order: what two tables of the same edges have in common.
/// Everything that was returned stays, up to a bound that no right table reaches.
inline std::vector<glm::uvec2> canonical(std::vector<glm::uvec2> edges, const IndexedMesh& mesh)
{
    edges.resize(std::min(edges.size(), 6 * mesh.triangles.size() + 10));
    for (glm::uvec2& edge : edges) edge = {std::min(edge.x, edge.y), std::max(edge.x, edge.y)};
    std::sort(edges.begin(), edges.end(),
              [](const glm::uvec2& a, const glm::uvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    return edges;
}

/// Glass: all edges, far ones dim, seen from a point on +z at this distance; `middle` is where the origin comes to lie.
/// An edge that comes twice is brighter.
inline void draw_wireframe(Drawing& drawing, const IndexedMesh& mesh, const std::vector<glm::uvec2>& edges,
                           glm::dvec2 middle, double distance, glm::vec3 near, glm::vec3 far)
{
    const auto project = [&](const glm::dvec3& p) { return middle + glm::dvec2(p) * distance / (distance - p.z); };
    for (const glm::uvec2& edge : edges) {
        if (edge.x >= mesh.positions.size() || edge.y >= mesh.positions.size()) continue;
        const glm::dvec3 a(mesh.positions[edge.x]);
        const glm::dvec3 b(mesh.positions[edge.y]);
        const double depth = std::clamp(0.5 + 0.2 * (a.z + b.z), 0.0, 1.0);
        drawing.line(project(a), project(b), glm::mix(far, near, static_cast<float>(depth)), 0.9 + 0.8 * depth,
                     0.3 + 0.5 * depth);
    }
}

}
