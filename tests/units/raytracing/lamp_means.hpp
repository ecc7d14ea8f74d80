#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <numbers>
#include <string>
#include <umbral/raytracing/area_lamp.hpp>

/// What tests of Monte Carlo estimates share: means with their errors, and the exact light of a lamp.
namespace umbral::tests {

inline constexpr double pi = std::numbers::pi;

/// Mean and its standard deviation of what `draw` returns.
struct Mean {
    glm::dvec3 mean{0};
    glm::dvec3 deviation{0};
};
template <class Draw>
Mean mean_of(int count, Draw draw)
{
    glm::dvec3 sum(0);
    glm::dvec3 squares(0);
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 value(draw());
        sum += value;
        squares += value * value;
    }
    const glm::dvec3 mean = sum / double(count);
    return {mean, sqrt(max(squares / double(count) - mean * mean, 0.0) / double(count))};
}

/// Within five standard deviations, and what rounding to float can do.
inline void expect_mean(const Mean& found, const glm::dvec3& expected, const std::string& what)
{
    std::printf("  %-42s %.5f %.5f %.5f, expected %.5f %.5f %.5f\n", what.c_str(), found.mean.x, found.mean.y,
                found.mean.z, expected.x, expected.y, expected.z);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found.mean[c], expected[c], 5 * found.deviation[c] + 2e-5 * expected[c] + 1e-6) << what << c;
}

/// The share of a surface's view that a lamp takes, weighted with the cosine: what Lambert's formula gives for its
/// edges. Based on: J. H. Lambert. Photometria. 1760. The lamp lies above the surface.
inline double form_factor(const glm::dvec3& point, const glm::dvec3& normal, const raytracing::AreaLamp& lamp)
{
    const glm::dvec3 corner = glm::dvec3(lamp.corner) - point;
    const glm::dvec3 a(lamp.edge_a);
    const glm::dvec3 b(lamp.edge_b);
    const std::array<glm::dvec3, 4> corners{corner, corner + a, corner + a + b, corner + b};
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 one = normalize(corners[i]);
        const glm::dvec3 next = normalize(corners[(i + 1) % 4]);
        sum += std::acos(dot(one, next)) * dot(normalize(cross(one, next)), normal);
    }
    return std::abs(sum) / (2 * pi);
}

}
