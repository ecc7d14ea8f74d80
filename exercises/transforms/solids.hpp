#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <kit/shapes.hpp>
#include <umbral/transforms/pipeline.hpp>
#include <vector>

/// The pipelines' solids as triangles, counter-clockwise from outside.
namespace umbral::transforms {

/// A place on a profile; two places in one with other normals make an edge.
struct ProfilePoint {
    float radius;
    float height;
    glm::vec2 normal;  ///< (outwards, up)
};

/// The surface that a profile, from bottom to top, sweeps about the y axis.
inline shapes::Shape swept(const std::vector<ProfilePoint>& profile)
{
    constexpr int around = 48;
    shapes::Shape solid;
    for (const ProfilePoint& point : profile) {
        for (int i = 0; i <= around; ++i) {
            const float angle = shapes::turn * static_cast<float>(i) / around;
            const glm::vec3 out(std::sin(angle), 0, std::cos(angle));
            solid.positions.push_back(point.radius * out + glm::vec3(0, point.height, 0));
            solid.normals.push_back(point.normal.x * out + glm::vec3(0, point.normal.y, 0));
        }
    }
    join_grid(solid, around, static_cast<int>(profile.size()) - 1);
    return solid;
}

inline shapes::Shape solid_of(Primitive primitive)
{
    if (primitive == Primitive::cylinder)
        return swept(
            {{0, 0, {0, -1}}, {1, 0, {0, -1}}, {1, 0, {1, 0}}, {1, 1, {1, 0}}, {1, 1, {0, 1}}, {0, 1, {0, 1}}});
    constexpr int rings = 16;
    std::vector<ProfilePoint> profile = {{0, 0, {0, -1}}, {1, 0, {0, -1}}};
    for (int i = 0; i <= rings; ++i) {
        const float angle = 0.25F * shapes::turn * static_cast<float>(i) / rings;
        profile.push_back({std::cos(angle), std::sin(angle), {std::cos(angle), std::sin(angle)}});
    }
    return swept(profile);
}

}
