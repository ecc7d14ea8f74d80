#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>
#include <umbral/transforms/pipeline.hpp>
#include <vector>

/// The pipelines' solids as triangles, counter-clockwise from outside.
namespace umbral::transforms {

struct Solid {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;
};

/// The surface that a profile (radius, height) sweeps about the y axis, from top to bottom; two places in one with other normals make an edge.
struct ProfilePoint {
    float radius;
    float height;
    glm::vec2 normal;  ///< (outwards, up)
};

inline Solid swept(const std::vector<ProfilePoint>& profile)
{
    constexpr std::uint32_t around = 48;
    Solid solid;
    for (const ProfilePoint& point : profile) {
        for (std::uint32_t i = 0; i <= around; ++i) {
            const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / around;
            const glm::vec3 out(std::sin(angle), 0, std::cos(angle));
            solid.positions.push_back(point.radius * out + glm::vec3(0, point.height, 0));
            solid.normals.push_back(point.normal.x * out + glm::vec3(0, point.normal.y, 0));
        }
    }
    for (std::uint32_t ring = 0; ring + 1 < profile.size(); ++ring) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t above = ring * (around + 1) + i;
            const std::uint32_t below = above + around + 1;
            solid.indices.insert(solid.indices.end(), {above, below, below + 1, above, below + 1, above + 1});
        }
    }
    return solid;
}

inline Solid solid_of(Primitive primitive)
{
    if (primitive == Primitive::cylinder) return swept({{0, 1, {0, 1}}, {1, 1, {0, 1}}, {1, 1, {1, 0}}, {1, 0, {1, 0}}, {1, 0, {0, -1}}, {0, 0, {0, -1}}});
    constexpr int rings = 16;
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= rings; ++i) {
        const float angle = 0.5F * std::numbers::pi_v<float> * static_cast<float>(i) / rings;
        profile.push_back({std::sin(angle), std::cos(angle), {std::sin(angle), std::cos(angle)}});
    }
    profile.push_back({1, 0, {0, -1}});
    profile.push_back({0, 0, {0, -1}});
    return swept(profile);
}

}
