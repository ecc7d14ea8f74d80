#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <kit/magnitude.hpp>
#include <numeric>
#include <umbral/core/grid.hpp>
#include <umbral/core/random.hpp>
#include <umbral/pipeline/rasterize.hpp>
#include <umbral/record/ask.hpp>
#include <utility>
#include <vector>

/// What the drivers of the pipeline share: triangles in window coordinates, aimed so that ties and hard cases occur.
namespace umbral::pipeline {

using Triangle = std::array<WindowVertex, 3>;

/// Uniform in [low, high), a multiple of 1/`parts` of a pixel; exact, so that rounding to 1/256 changes nothing.
inline float on_grid(Random& random, int low, int high, int parts)
{
    return static_cast<float>(low) +
           static_cast<float>(random.below(static_cast<std::uint32_t>((high - low) * parts))) /
               static_cast<float>(parts);
}

/// w from 1 to 8, any depth: the two do not belong together, so that neither can be made from the other.
inline WindowVertex random_vertex(Random& random, glm::vec2 position)
{
    const float depth = random.uniform();
    return {position, depth, std::exp2(-3 * random.uniform())};
}

/// All three w in a unit of their own: distances may be tens of thousands, and the weights stay what they are.
inline Triangle random_attributes(Random& random, const std::array<glm::vec2, 3>& positions)
{
    Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = random_vertex(random, positions[i]);
    const float unit = random_unit(random, -16, 4);
    for (WindowVertex& vertex : triangle) vertex.inverse_w *= unit;
    return triangle;
}

/// The same triangle, begun at a random corner and turned either way.
inline std::array<glm::vec2, 3> shuffled(Random& random, std::array<glm::vec2, 3> positions)
{
    std::rotate(positions.begin(), positions.begin() + random.below(3), positions.end());
    if (random.below(2) == 0) std::swap(positions[0], positions[1]);
    return positions;
}

/// A square of `cells` x `cells` cells of 4 pixels, its inner corners moved by up to a pixel in halves (many lie on
/// centres and many edges pass through some), each cell cut along a random diagonal. Every pixel belongs to exactly one
/// triangle.
inline std::vector<std::array<glm::vec2, 3>> random_partition(Random& random, int cells)
{
    Grid<glm::vec2> corners(cells + 1, cells + 1);
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            const bool inner = row > 0 && row < cells && column > 0 && column < cells;
            const float x = inner ? on_grid(random, -1, 1, 2) : 0;
            corners.at(column, row) =
                glm::vec2(4 * column, 4 * row) + glm::vec2(x, inner ? on_grid(random, -1, 1, 2) : 0);
        }
    std::vector<std::array<glm::vec2, 3>> triangles;
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const glm::vec2 a = corners.at(column, row);
            const glm::vec2 b = corners.at(column + 1, row);
            const glm::vec2 c = corners.at(column + 1, row + 1);
            const glm::vec2 d = corners.at(column, row + 1);
            const bool falling = random.below(2) == 0;
            triangles.push_back(shuffled(random, {a, b, falling ? c : d}));
            triangles.push_back(shuffled(random, {falling ? a : b, c, d}));
        }
    return triangles;
}

/// Triangles about one point, their outer corners on a square of `radius` pixels, in steps of an eighth of it.
inline std::vector<std::array<glm::vec2, 3>> fan(Random& random, glm::vec2 centre, float radius)
{
    std::vector<glm::vec2> rim;
    for (int i = 0; i < 16; ++i) rim.emplace_back(static_cast<float>(i) / 8 - 1, -1);
    for (int i = 0; i < 16; ++i) rim.emplace_back(1, static_cast<float>(i) / 8 - 1);
    for (int i = 0; i < 16; ++i) rim.emplace_back(1 - static_cast<float>(i) / 8, 1);
    for (int i = 0; i < 16; ++i) rim.emplace_back(-1, 1 - static_cast<float>(i) / 8);
    std::vector<std::array<glm::vec2, 3>> triangles;
    for (std::size_t i = 0; i < rim.size(); ++i)
        triangles.push_back(
            shuffled(random, {centre, centre + radius * rim[i], centre + radius * rim[(i + 1) % rim.size()]}));
    return triangles;
}

/// A pixel's centre and a whole number of pixels from it to another one, within a picture.
struct Aim {
    glm::vec2 centre;
    glm::vec2 step;
};

inline Aim random_aim(Random& random, int width, int height)
{
    const auto size = glm::vec2(width, height);
    Aim aim{{0, 0}, {0, 0}};
    glm::vec2 other(0);
    for (int axis = 0; axis < 2; ++axis) {
        aim.centre[axis] = on_grid(random, 0, static_cast<int>(size[axis]), 1) + 0.5F;
        other[axis] = on_grid(random, 0, static_cast<int>(size[axis]), 1) + 0.5F;
    }
    aim.step = other - aim.centre;
    if (aim.step == glm::vec2(0)) aim.step = {1, 2};
    return aim;
}

/// How many whole steps lead from a place to the border of the guard band, at most.
inline float steps_inside(const Aim& aim, float side)
{
    float steps = 16384;
    for (int axis = 0; axis < 2; ++axis)
        if (aim.step[axis] != 0)
            steps = std::min(steps, (16383 - std::abs(aim.centre[axis])) / std::abs(aim.step[axis]));
    return side * std::floor(steps);
}

/// A triangle as large as the guard band admits, with one side exactly through centres of pixels; or a sliver of at
/// most two pixels along it.
inline std::array<glm::vec2, 3> huge_triangle(Random& random, int width, int height, bool sliver)
{
    const Aim aim = random_aim(random, width, height);
    const glm::vec2 a = aim.centre + steps_inside(aim, 1) * aim.step;
    const glm::vec2 b = aim.centre + steps_inside(aim, -1) * aim.step;
    const float x = sliver ? on_grid(random, -2, 2, 256) : on_grid(random, -16384, 16384, 256);
    const float y = sliver ? on_grid(random, -2, 2, 256) : on_grid(random, -16384, 16384, 256);
    return shuffled(random, {a, b, (sliver ? aim.centre : glm::vec2(0)) + glm::vec2(x, y)});
}

/// A vector v with cross(u, v) = k that does not lead back along u, nor farther than u itself. Needs coprime
/// coordinates of u (Euclid).
inline glm::i64vec2 nearly_along(const glm::i64vec2& u, std::int64_t k)
{
    glm::i64vec2 rest(u);
    glm::i64vec2 first(1, 0);  // invariant: first.x * u.x + first.y * u.y = rest.x, and second likewise rest.y
    glm::i64vec2 second(0, 1);
    while (rest.y != 0) {
        const std::int64_t quotient = rest.x / rest.y;
        rest = {rest.y, rest.x - quotient * rest.y};
        first = std::exchange(second, first - quotient * second);
    }
    const glm::i64vec2 v = k * rest.x * glm::i64vec2(-first.y, first.x);
    const double turns =
        (static_cast<double>(v.x) * static_cast<double>(u.x) + static_cast<double>(v.y) * static_cast<double>(u.y)) /
        (static_cast<double>(u.x) * static_cast<double>(u.x) + static_cast<double>(u.y) * static_cast<double>(u.y));
    return v - static_cast<std::int64_t>(std::floor(turns)) * u;
}

/// A triangle up to twice `reach` (at most 16,000) pixels wide and high, but only about a millionth thick, that begins
/// far from the centre of a pixel in the picture and ends behind it: its long sides pass the centre with cross products
/// of 1 to 30 in units of 1/65536 pixel squared, one on each side of it, or both on one.
inline std::array<glm::vec2, 3> needle(Random& random, int width, int height, int reach, bool covers)
{
    const int column = static_cast<int>(random.below(static_cast<std::uint32_t>(width)));
    const glm::i64vec2 centre(256 * column + 128,
                              256 * static_cast<int>(random.below(static_cast<std::uint32_t>(height))) + 128);
    const auto far = [&] {
        const auto length = static_cast<std::int64_t>(
            64 * reach + static_cast<int>(random.below(static_cast<std::uint32_t>(192 * reach))));
        return random.below(2) == 0 ? length : -length;
    };
    glm::i64vec2 u(0);
    u.x = far();
    u.y = far();
    while (std::gcd(u.x, u.y) != 1) --u.y;
    const std::int64_t one = 1 + random.below(30);
    const std::int64_t other = 1 + random.below(30);
    const std::array<glm::i64vec2, 3> corners = {centre - u, centre + nearly_along(u, one),
                                                 centre + nearly_along(u, covers ? -other : one + other)};
    return shuffled(random,
                    {glm::vec2(corners[0]) / 256.0F, glm::vec2(corners[1]) / 256.0F, glm::vec2(corners[2]) / 256.0F});
}

/// A triangle with one side exactly through a pixel's centre once its corners are rounded to 1/256 pixel. Before that
/// they lie up to half of 1/256 pixel off, a quarter of them exactly half: on a tie.
inline std::array<glm::vec2, 3> unrounded_triangle(Random& random, int size)
{
    const auto fraction = [&](int reach) { return on_grid(random, -reach, reach, 256); };
    const float column = on_grid(random, 0, size, 1) + 0.5F;
    const glm::vec2 centre(column, on_grid(random, 0, size, 1) + 0.5F);
    const float dx = fraction(2);
    const glm::vec2 step(dx, fraction(2) + 1.0F / 512 * 2);
    const float third = on_grid(random, 0, size, 256);
    std::array<glm::vec2, 3> corners = {centre + step * on_grid(random, 1, 6, 1),
                                        centre - step * on_grid(random, 1, 6, 1),
                                        glm::vec2(third, on_grid(random, 0, size, 256))};
    for (glm::vec2& corner : corners)
        for (int axis = 0; axis < 2; ++axis) {
            const bool tie = random.below(4) == 0;
            const float off = random.uniform(-0.49F, 0.49F);
            corner[axis] += (tie ? std::copysign(0.5F, off) : off) / 256;
        }
    return shuffled(random, corners);
}

/// Half a box whose sides lie on rows and columns of centres once its corners are rounded, and beside them before: a
/// box of pixels that is found from unrounded corners loses them.
inline std::array<glm::vec2, 3> half_box_beside_centres(Random& random, int size)
{
    const float left = on_grid(random, 0, size - 8, 1);
    const glm::vec2 low(left, on_grid(random, 0, size - 8, 1));
    const float width = on_grid(random, 1, 6, 1);
    const glm::vec2 high = low + glm::vec2(width, on_grid(random, 1, 6, 1));
    std::array<glm::vec2, 4> corners = {low, {high.x, low.y}, high, {low.x, high.y}};
    std::rotate(corners.begin(), corners.begin() + random.below(4), corners.end());
    for (glm::vec2& corner : corners)
        for (int axis = 0; axis < 2; ++axis) corner[axis] += 0.5F + random.uniform(-0.49F, 0.49F) / 256;
    return {corners[0], corners[1], corners[2]};
}

/// Corners within 3/256 of a centre: the triangle covers that pixel or none.
inline std::array<glm::vec2, 3> speck(Random& random, int width, int height)
{
    const float column = on_grid(random, 0, width - 1, 1) + 0.5F;
    const glm::vec2 centre(column, on_grid(random, 0, height - 1, 1) + 0.5F);
    std::array<glm::vec2, 3> corners{};
    for (glm::vec2& corner : corners)
        for (int axis = 0; axis < 2; ++axis)
            corner[axis] = centre[axis] + static_cast<float>(static_cast<int>(random.below(7)) - 3) / 256;
    return corners;
}

/// Draws all triangles and takes down what they cover: rows [triangle, x, y], with the three weights and the depth if
/// asked for. Of triangles that cover a pixel at most, several together count as one: else their boxes would tell what
/// they cover.
inline void record(Recorder& out, const std::vector<Triangle>& triangles, int width, int height, bool attributes,
                   std::size_t together = 1)
{
    std::vector<Fragment> fragments;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        fragments.clear();
        ask<rasterize_triangle>(out, triangles[i], width, height, fragments);
        for (const auto& [pixel, depth, weights] : fragments) {
            const std::array<float, 3> where = {static_cast<float>(i / together), static_cast<float>(pixel.x),
                                                static_cast<float>(pixel.y)};
            out.append("coverage", std::span<const float>(where));
            if (!attributes) continue;
            out.append("weights", std::span<const float>(
                                      std::array{where[0], where[1], where[2], weights[0], weights[1], weights[2]}));
            out.append("depth", std::span<const float>(std::array{where[0], where[1], where[2], depth}));
        }
    }
}

}
