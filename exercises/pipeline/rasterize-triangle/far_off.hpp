#pragma once

#include <array>
#include <vector>

#include "../support.hpp"

/// Triangles that reach far out of the picture, to its guard band or to the horizon.
namespace umbral::pipeline {

inline std::vector<Triangle> with_attributes(Random& random, const std::vector<std::array<glm::vec2, 3>>& corners)
{
    std::vector<Triangle> triangles;
    for (const std::array<glm::vec2, 3>& positions : corners) triangles.push_back(random_attributes(random, positions));
    return triangles;
}

/// Corners exactly on the guard band's border, which belongs to it, or an ulp beyond. Each triangle has one such corner
/// or two, and its other side in the upper left 24 x 24 pixels.
inline std::vector<std::array<glm::vec2, 3>> on_the_border(Random& random)
{
    std::vector<std::array<glm::vec2, 3>> corners;
    for (int i = 0; i < 32; ++i) {
        const int axis = i % 2;
        const float sign = i / 2 % 2 == 0 ? 1.0F : -1.0F;
        const float end = sign * (i / 4 % 2 == 0 ? 16384.0F : 16384.001953125F);
        const auto placed = [&](float along, float across) {
            return axis == 0 ? glm::vec2(along, across) : glm::vec2(across, along);
        };
        // Not many pixels of each, so that none outnumbers the others.
        const float base = sign > 0 ? on_grid(random, 16, 22, 256) : on_grid(random, 2, 8, 256);
        const float low = on_grid(random, 1, 6, 256);
        const float high = on_grid(random, 15, 22, 256);
        const float there = on_grid(random, 8, 14, 256);
        corners.push_back({placed(base, low), placed(base, high), placed(end, there)});
        if (i >= 24) corners.back()[1] = placed(end, there + 2);
        corners.back() = shuffled(random, corners.back());
    }
    return corners;
}

/// For a picture of 40 x 24 pixels: ground seen from just above it, w from 1 at corners far outside the picture to 1000
/// at the horizon inside it; two times in five all of it is so far away that no two of its 1/w differ by more than a
/// thousandth.
inline std::vector<Triangle> horizon(Random& random)
{
    std::vector<Triangle> triangles;
    for (int i = 0; i < 20; ++i) {
        const float left = on_grid(random, -16000, -8000, 256);
        const float right = on_grid(random, 8000, 16000, 256);
        const float below = on_grid(random, 8000, 16000, 256);
        const float x = on_grid(random, 4, 36, 256);
        const glm::vec2 vanishing(x, on_grid(random, 0, 4, 256));
        const bool all_far = i % 5 > 2;
        const float near = random.uniform(1, 2) * (all_far ? 1500.0F : 1.0F);
        const float far = random.uniform(500, 1000) * (all_far ? 1500.0F : 1.0F);
        Triangle ground = {
            WindowVertex{{left, below}, 0, 1 / near}, {{right, below + 3}, 0, 1 / near}, {vanishing, 0.999F, 1 / far}};
        std::rotate(ground.begin(), ground.begin() + i % 3, ground.end());
        triangles.push_back(ground);
    }
    return triangles;
}

}
