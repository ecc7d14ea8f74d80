#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "render/fields/isosurface.hpp"
#include "render/sheet.hpp"

namespace umbral::render {
namespace {

/// As the unit sphere's, in the same direction.
glm::vec2 seen_from_origin(const glm::vec3& place)
{
    const glm::dvec3 p(place);
    const double round = std::atan2(p.x, p.z) / (2 * std::numbers::pi);
    const double up = std::atan2(p.y, std::hypot(p.x, p.z)) / std::numbers::pi + 0.5;
    return {round < 0 ? round + 1 : round, up};
}

}

Surface make_solid(const scene::DistanceField& field)
{
    Surface surface;
    surface.mesh = fields::isosurface(fields::field_of(field.field), field.cells);
    for (const glm::vec3& place : surface.mesh.positions) surface.uvs.push_back(seen_from_origin(place));
    if (surface.uvs.empty()) surface.uvs.emplace_back(0);
    // Across the seam u goes on beyond 1.
    for (const glm::uvec3& triangle : surface.mesh.triangles) {
        glm::uvec3 corners = triangle;
        const auto u = [&](int i) { return surface.uvs[triangle[i]].x; };
        const float largest = std::max({u(0), u(1), u(2)});
        for (int i = 0; i < 3; ++i) {
            const glm::vec2 uv = surface.uvs[triangle[i]];
            if (largest - uv.x <= 0.5F) continue;
            corners[i] = static_cast<unsigned>(surface.uvs.size());
            surface.uvs.emplace_back(uv.x + 1, uv.y);
        }
        surface.uv_triangles.push_back(corners);
    }
    return surface;
}

}
