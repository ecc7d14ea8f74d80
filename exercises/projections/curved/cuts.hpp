#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <umbral/core/random.hpp>
#include <umbral/projections/curved.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// How triangles that were cut are recorded, in whatever order they come.
namespace umbral::projections {

using Triangle = std::array<glm::vec3, 3>;

inline bool is_less(const glm::vec3& a, const glm::vec3& b)
{
    for (int axis = 0; axis < 3; ++axis)
        if (a[axis] != b[axis]) return a[axis] < b[axis];
    return false;
}

inline bool comes_before(const Triangle& a, const Triangle& b)
{
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), is_less);
}

/// Triangles that begin at their least corner, the least triangles first. Most corners here are whole multiples of
/// 2^-12, so every middle is exact; others are rounded in one way only. So there is no other order.
inline std::vector<Triangle> sorted(const std::vector<glm::vec3>& corners)
{
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i + 3 <= corners.size(); i += 3) {
        Triangle next{corners[i], corners[i + 1], corners[i + 2]};
        Triangle turned = next;
        for (int corner = 1; corner < 3; ++corner) {
            std::rotate(turned.begin(), turned.begin() + 1, turned.end());
            if (comes_before(turned, next)) next = turned;
        }
        triangles.push_back(next);
    }
    std::sort(triangles.begin(), triangles.end(), comes_before);
    return triangles;
}

/// Triangles within 16 of the eye, their coordinates whole multiples of 1/8.
inline std::vector<glm::vec3> random_triangles(std::size_t count, Random& random)
{
    std::vector<glm::vec3> corners(3 * count);
    const auto coordinate = [&] { return static_cast<float>(random.below(257)) / 8 - 16; };
    for (glm::vec3& corner : corners)
        for (int axis = 0; axis < 3; ++axis) corner[axis] = coordinate();
    return corners;
}

/// Many kilometres large, with an edge past the eye: its middle is exact, and the way from one end to the other is not.
inline std::vector<glm::vec3> triangle_past_the_eye(Random& random)
{
    std::vector<glm::vec3> corners(3);
    for (int axis = 0; axis < 3; ++axis) {
        const auto far = [&] {
            const float size = 0.0625F * (9e6F + static_cast<float>(random.below(7000000)));
            return random.below(2) == 0 ? size : -size;
        };
        corners[0][axis] = far();
        corners[1][axis] = 0.0625F * static_cast<float>(random.below(513)) - 16 - corners[0][axis];
        corners[2][axis] = far();
    }
    return corners;
}

/// How many triangles there are, and eight of them, taken evenly from the sorted list.
inline void record_cut(Recorder& out, const std::vector<glm::vec3>& corners, float largest_angle)
{
    const std::vector<glm::vec3> cut = ask<tessellated>(out, corners, largest_angle);
    out.append("count", static_cast<float>(cut.size()));
    const std::vector<Triangle> triangles = sorted(cut);
    for (std::size_t i = 0; i < 8; ++i) {
        Triangle row;
        row.fill(glm::vec3(-1000));  // stands for no triangle
        if (!triangles.empty()) row = triangles[i * triangles.size() / 8];
        std::array<float, 9> numbers{};
        for (std::size_t k = 0; k < 9; ++k) numbers[k] = row[k / 3][static_cast<int>(k % 3)];
        out.append("triangles", std::span<const float>(numbers));
    }
}

/// One that is fine as it is; one that is cut once, and twice; two of which only one would need it; the eye within, at
/// a corner, and on an edge; one edge only that is too wide, each in its turn; one without area; edges of thousands of
/// kilometres past the eye, whose middle is near it; none at all.
inline void record_known_cuts(Variation& vary, Recorder& out)
{
    // Turned by quarters of a turn only, in which no coordinate is rounded.
    const auto record_triangles = [&](std::vector<glm::vec3> corners, float angle) {
        const ExactMap map = vary.exact_map(1);
        for (glm::vec3& corner : corners) corner = map.place(corner) + 0.0F;  // no -0
        record_cut(out, corners, angle);
    };
    const std::vector<glm::vec3> wall = {{-1, 0, -2}, {1, 0, -2}, {0, 2, -2}};
    for (const float angle : {3.0F, 1.0F, 0.75F, 0.5F, 0.25F}) record_triangles(wall, vary.scaled(angle, 1.4F));
    record_triangles({{-1, 0, -2}, {1, 0, -2}, {0, 2, -2}, {0, 0, -64}, {1, 0, -64}, {0, 1, -64}}, 0.75F);
    record_triangles({{-4, -1, 4}, {4, -1, 4}, {0, -1, -6}}, 0.5F);
    record_triangles({{0, 0, 0}, {4, 0, -4}, {0, 4, -4}}, 0.3F);
    record_triangles({{-4, 0, 0}, {4, 0, 0}, {0, 4, -4}}, 4);
    for (const std::vector<glm::vec3>& flat : {std::vector<glm::vec3>{{1, 0, -2}, {0, 0.25F, -2}, {-1, 0, -2}},
                                               {{0, 0.25F, -2}, {-1, 0, -2}, {1, 0, -2}},
                                               {{-1, 0, -2}, {1, 0, -2}, {0, 0.25F, -2}}})
        record_triangles(flat, 0.75F);
    record_triangles({{-1, 0, -2}, {-1, 0, -2}, {2, 1, -2}}, 0.5F);
    record_triangles({{-1, 1, -2}, {1, 0, -4}, {-1, 0, -2}, {2, 1, -3}, {0, 2, -3}, {0, 2, -3}}, 0.5F);
    for (const float angle : {1.0F, 2.5F})
        record_triangles({{-1000000.0625F, 900000.3125F, -800000.1875F},
                          {1000003.5F, -900004, 800001.25F},
                          {700000.75F, 600000.5F, -900000.0625F}},
                         angle);
    record_triangles({}, 0.5F);
}

}
