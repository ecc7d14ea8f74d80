#include "scene/sphere_uvs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbral::scene {
namespace {

glm::vec2 seen_from_origin(const glm::vec3& place)
{
    const glm::dvec3 p(place);
    const double round = std::atan2(p.x, p.z) / (2 * std::numbers::pi);
    const double up = std::atan2(p.y, std::hypot(p.x, p.z)) / std::numbers::pi + 0.5;
    return {round < 0 ? round + 1 : round, up};
}

}

SphereUvs sphere_uvs(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles)
{
    SphereUvs map;
    for (const glm::vec3& place : positions) map.uvs.push_back(seen_from_origin(place));
    if (map.uvs.empty()) map.uvs.emplace_back(0);
    for (const glm::uvec3& triangle : triangles) {
        glm::uvec3 corners = triangle;
        const auto u = [&](int i) { return map.uvs[triangle[i]].x; };
        const float largest = std::max({u(0), u(1), u(2)});
        for (int i = 0; i < 3; ++i) {
            const glm::vec2 uv = map.uvs[triangle[i]];
            if (largest - uv.x <= 0.5F) continue;
            corners[i] = static_cast<unsigned>(map.uvs.size());
            map.uvs.emplace_back(uv.x + 1, uv.y);
        }
        map.triangles.push_back(corners);
    }
    return map;
}

}
