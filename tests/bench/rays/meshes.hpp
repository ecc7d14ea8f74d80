#pragma once

#include <cmath>
#include <numbers>
#include <umbral/core/random.hpp>
#include <vector>

#include "raytrace/hierarchy.hpp"

namespace umbral::raytrace::bench {

/// A hilly sphere without gaps, of 4 rings² triangles: hills of many sizes, as scanned objects have them.
[[nodiscard]] inline std::vector<Corners> hilly_sphere(int rings)
{
    const auto corner = [&](int i, int j) {
        const double polar = std::numbers::pi * i / rings;
        const double azimuth = std::numbers::pi * (j % (2 * rings)) / rings;
        double radius = 1;
        const double fades = std::sin(polar) * std::sin(polar);
        for (const int waves : {3, 11, 37, 113})
            radius += 0.25 / waves * fades * std::sin(waves * azimuth) * std::sin(waves * polar);
        return glm::vec3(radius * glm::dvec3(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                             std::sin(polar) * std::sin(azimuth)));
    };
    std::vector<glm::vec3> row;
    std::vector<glm::vec3> above;
    for (int j = 0; j <= 2 * rings; ++j) above.push_back(corner(0, j));
    std::vector<Corners> all;
    all.reserve(4 * static_cast<std::size_t>(rings) * static_cast<std::size_t>(rings));
    for (int i = 1; i <= rings; ++i) {
        row.clear();
        for (int j = 0; j <= 2 * rings; ++j) row.push_back(corner(i, j));
        for (std::size_t j = 0; j + 1 < row.size(); ++j) {
            all.push_back({above[j], above[j + 1], row[j + 1]});
            all.push_back({above[j], row[j + 1], row[j]});
        }
        std::swap(row, above);
    }
    return all;
}

/// Rays from one eye, in the order of a picture's rows.
[[nodiscard]] inline std::vector<Ray> primary_rays(int side)
{
    std::vector<Ray> rays;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const float scale = 2.0F / static_cast<float>(side);
            rays.push_back({{0, 0, 3},
                            {0.4F * (scale * (static_cast<float>(x) + 0.5F) - 1),
                             0.4F * (1 - scale * (static_cast<float>(y) + 0.5F)), -1}});
        }
    return rays;
}

/// From where these rays meet the mesh: towards one lamp, or in any direction over the surface's outside.
[[nodiscard]] inline std::vector<Ray> second_rays(const Hierarchy& hierarchy, const std::vector<Ray>& first,
                                                  bool shadow)
{
    Random random(7);
    std::vector<Ray> rays;
    for (const Ray& ray : first) {
        const Hit hit = first_hit(hierarchy, ray);
        if (hit.triangle == Hit::nothing) continue;
        const glm::vec3 place = ray.origin + hit.t * ray.direction;
        const glm::vec3 up = normalize(place);
        const glm::vec3 towards = shadow ? glm::vec3(2, 3, 2) - place : normalize(up + random.unit_vector());
        rays.push_back({place + 1e-3F * up, towards, 0, shadow ? 1 : std::numeric_limits<float>::infinity()});
    }
    return rays;
}

/// Between two points of the ball of radius 1.5, in no order.
[[nodiscard]] inline std::vector<Ray> random_rays(std::size_t count)
{
    Random random(11);
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 from = 1.5F * random.unit_vector();
        rays.push_back({from, 1.5F * random.unit_vector() - from});
    }
    return rays;
}

}
