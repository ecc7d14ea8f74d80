#include <algorithm>
#include <array>
#include <umbral/core/random.hpp>

#include "raster.hpp"

namespace umbral::bench {
namespace {

using Triangle = std::array<RasterVertex, 3>;

Triangle triangle(Random& random, const std::array<glm::vec2, 3>& pixels, int side)
{
    Triangle corners{};
    const float depth = random.uniform(-0.9F, 0.9F);
    for (std::size_t i = 0; i < 3; ++i) {
        const float w = random.uniform(1, 2);
        const glm::vec2 place = pixels[i] * (2.0F / static_cast<float>(side)) - 1.0F;
        corners[i] = {w * glm::vec4(place, depth + random.uniform(-0.05F, 0.05F), 1),
                      {random.uniform(), random.uniform(), random.uniform()}};
    }
    return corners;
}

}

std::vector<RasterVertex> raster_workload(int legs, int side, bool scattered)
{
    Random random(static_cast<std::uint64_t>(legs));
    constexpr std::size_t most = 60'000;
    constexpr double pixels = 4e6;
    const auto wanted = std::min(most, static_cast<std::size_t>(pixels / (0.5 * legs * legs)));
    std::vector<Triangle> triangles;
    while (triangles.size() < wanted) {
        const glm::vec2 moved(random.uniform(-0.5F, 0.5F), random.uniform(-0.5F, 0.5F));
        for (int y = 0; y + legs <= side && triangles.size() < wanted; y += legs)
            for (int x = 0; x + legs <= side && triangles.size() < wanted; x += legs) {
                const auto at = [&](int dx, int dy) {
                    return glm::clamp(glm::vec2(x + dx, y + dy) + moved, 0.0F, static_cast<float>(side));
                };
                triangles.push_back(triangle(random, {at(0, 0), at(legs, 0), at(0, legs)}, side));
                triangles.push_back(triangle(random, {at(legs, legs), at(0, legs), at(legs, 0)}, side));
            }
    }
    if (scattered)
        for (std::size_t i = triangles.size(); i > 1; --i)
            std::swap(triangles[i - 1], triangles[random.below(static_cast<std::uint32_t>(i))]);
    std::vector<RasterVertex> vertices;
    for (const Triangle& corners : triangles) vertices.insert(vertices.end(), corners.begin(), corners.end());
    return vertices;
}

}
