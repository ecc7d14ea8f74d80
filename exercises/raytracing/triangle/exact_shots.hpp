#pragma once

#include <utility>

#include "shots.hpp"

/// Rays and triangles whose numbers are exact in every formula, so that the answer is sure on an edge and close to it.
namespace umbral::raytracing {

/// What an exact shot lies in: a triangle across an axis.
struct ExactPlane {
    glm::vec3 corner;
    glm::vec3 x;  ///< one part of the leg to v1, and of that to v2
    glm::vec3 y;
    glm::vec3 direction;
};

/// Its legs along axes have parts of `part`. The plane goes through the origin, if its corner's place across both legs
/// is to be 0, where floats lie close together.
inline ExactPlane exact_plane(Random& random, float part, bool at_origin)
{
    const glm::vec3 corner = part * glm::vec3(glm::ivec3(4.0F * random.in_cube()));
    const int along = static_cast<int>(random.below(3));
    ExactPlane plane{glm::vec3(0), glm::vec3(0), glm::vec3(0), glm::vec3(0)};
    plane.corner[along] = corner[along];
    if (!at_origin) plane.corner = corner;
    plane.x[(along + 1) % 3] = random.below(2) == 0 ? part : -part;
    plane.y[(along + 2) % 3] = random.below(2) == 0 ? part : -part;
    plane.direction[along] = random.below(2) == 0 ? part : -part;
    if (random.below(2) == 0) std::swap(plane.x, plane.y);
    return plane;
}

/// A ray along an axis through the place (a, b), in parts, of a triangle across it with legs of so many parts, which
/// are powers of two in size. It meets it at `height` lengths of its direction.
inline TriangleShot exact_shot(Random& random, glm::vec2 place, float height, float parts = 4)
{
    const auto [corner, x, y, direction] = exact_plane(random, exact_size(random), false);
    const glm::vec3 point = corner + place.x * x + place.y * y;
    return {Ray{point - height * direction, direction}, {corner, corner + parts * x, corner + parts * y}};
}

/// The same triangle, of which another corner may be the first one.
inline Triangle begun_anywhere(Triangle triangle, Random& random)
{
    for (std::uint32_t turns = random.below(3); turns > 0; --turns) triangle = {triangle.v1, triangle.v2, triangle.v0};
    return triangle;
}

/// Points of the edges that divide them into 3, 5, 6 or 7 parts: their weights are rounded, but on which side of the
/// edge they lie is not. The twin passes beside it, by a part or by 2e-6 to 2e-5 of the side.
inline void add_odd_parts(std::vector<TriangleShot>& shots, Random& random)
{
    constexpr float numbers[] = {3, 5, 6, 7};
    for (int i = 0; i < 90; ++i) {
        const float parts = numbers[random.below(4)];
        const float k = 1.0F + static_cast<float>(random.below(static_cast<std::uint32_t>(parts) - 1));
        const glm::vec2 on[] = {{k, parts - k}, {0, k}, {k, parts - k}, {k, 0}};
        const glm::vec2 outwards[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
        const float by = i % 8 < 4 ? 1.0F : std::ldexp(1.0F, -14 - static_cast<int>(random.below(3)));
        TriangleShot hit = exact_shot(random, on[i % 4], 3, parts);
        hit.triangle = begun_anywhere(hit.triangle, random);
        add_pair(shots, hit, exact_shot(random, on[i % 4] + by * outwards[i % 4], 3, parts), random);
    }
}

/// Rays through an edge, or inside by as little as the twin passes outside: by 1e-13 to 5e-7 of the side.
inline void add_close_to_edges(std::vector<TriangleShot>& shots, int count, Random& random)
{
    for (int i = 0; i < count; ++i) {
        const auto [corner, x, y, direction] = exact_plane(random, exact_size(random), true);
        const float along = static_cast<float>(1 + random.below(3));
        const float by = std::ldexp(1.0F, -19 - static_cast<int>(random.below(22)));
        const Triangle triangle = begun_anywhere({corner, corner + 4.0F * x, corner + 4.0F * y}, random);
        const auto at = [&](float beside) {
            return TriangleShot{Ray{corner + beside * x + along * y - 3.0F * direction, direction}, triangle};
        };
        add_pair(shots, at(random.below(2) == 0 ? 0 : by), at(-by), random);
    }
}

/// Slivers whose edges enclose angles of 1e-9 to 1e-5, met squarely in their middle; the twin passes them by as far.
inline void add_slivers(std::vector<TriangleShot>& shots, int count, Random& random)
{
    for (int i = 0; i < count; ++i) {
        const auto [corner, x, y, direction] = exact_plane(random, exact_size(random), true);
        const float width = std::ldexp(1.0F, -17 - static_cast<int>(random.below(14)));
        const Triangle triangle =
            begun_anywhere({corner, corner + 4.0F * x, corner + 4.0F * x + 4.0F * width * y}, random);
        const auto at = [&](float right, float up) {
            return TriangleShot{Ray{corner + right * x + up * width * y - 3.0F * direction, direction}, triangle};
        };
        const TriangleShot misses[] = {at(2, -1), at(2, 3), at(5, 1)};
        add_pair(shots, at(2, 1), misses[i % 3], random);
    }
}

/// Needles of whole numbers across an axis, up to six million long, whose area is 8: the products that it is a
/// difference of are equal when they are rounded to float. The ray meets them in their middle, and the twin passes one
/// beside it.
inline void add_needles(std::vector<TriangleShot>& shots, int count, Random& random)
{
    const auto whole = [&](float reach) { return glm::vec3(glm::ivec3(reach * random.in_cube())); };
    for (int i = 0; i < count; ++i) {
        const float m = std::floor(std::exp2(random.uniform(11, 20)));
        const int along = static_cast<int>(random.below(3));
        const glm::vec3 corner = whole(1000);
        const auto place = [&](float x, float y) {
            glm::vec3 p = corner;
            p[(along + 1) % 3] += x;
            p[(along + 2) % 3] += y;
            return p;
        };
        glm::vec3 direction(0);
        direction[along] = random.below(2) == 0 ? 1.0F : -2.0F;
        const float side = random.below(2) == 0 ? 1.0F : -1.0F;
        const Triangle triangle =
            begun_anywhere({corner, place(4 * (m + 1), 4 * side * m), place(4 * m, 4 * side * (m - 1))}, random);
        const auto at = [&](float beside) {
            const glm::vec3 target = place(2 * m + 1 + beside, side * (2 * m - 1));
            return TriangleShot{Ray{target - 3.0F * direction, direction}, triangle};
        };
        add_pair(shots, at(0), at(random.below(2) == 0 ? 1.0F : -1.0F), random);
    }
}

}
