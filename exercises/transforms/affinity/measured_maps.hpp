#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>
#include <umbral/transforms/affinity.hpp>
#include <vector>

#include "../support.hpp"

/// Maps to find and to doubt: points, and where affine maps take them, exactly or nearly.
namespace umbral::transforms {

using Pairs = std::vector<PointPair>;

/// A turn, a stretch of 0.5 to 2, a shear and a move.
inline glm::dmat4 some_affine_map(Random& random)
{
    const AxisAngle turn = random_turn(random);
    glm::dmat4 map = glm::rotate(glm::dmat4(1), double{turn.angle}, glm::dvec3(turn.axis));
    for (int column = 0; column < 3; ++column) {
        const glm::dvec3 lean = 0.25 * glm::dvec3(random.in_cube());
        map[column] = random.uniform_double() * map[column] + 0.5 * map[column] + glm::dvec4(lean, 0);
    }
    map[3] = glm::dvec4(4.0 * glm::dvec3(random.in_cube()), 1);
    return map;
}

/// One time in three onto a plane, a line or a point, across axes of the world: a map that is affine and has no
/// inverse.
inline glm::dmat4 sometimes_flattened(glm::dmat4 map, Random& random)
{
    const std::uint32_t kept = random.below(3);
    const std::uint32_t axes = 1 + random.below(3);
    const std::uint32_t first = random.below(3);
    if (kept != 0) return map;
    for (std::uint32_t i = 0; i < axes; ++i)
        for (int column = 0; column < 3; ++column) map[column][static_cast<int>((first + i) % 3)] = 0;
    return map;
}

/// The same in other units of length.
inline glm::dmat4 scaled(const glm::dmat4& map, double size)
{
    return glm::scale(glm::dmat4(1), glm::dvec3(size)) * map;
}

/// Corners of a tetrahedron that leans, and `more` points about it.
inline std::vector<glm::vec3> some_points(Random& random, std::size_t more)
{
    const glm::vec3 first = random.in_cube();
    std::vector<glm::vec3> points{first};
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 edge = 0.3F * random.in_cube();
        edge[axis] += random.below(2) == 0 ? 1.0F : -1.0F;
        points.push_back(first + edge);
    }
    for (std::size_t i = 0; i < more; ++i) points.push_back(first + random.in_cube());
    return points;
}

inline Pairs pairs_of(const std::vector<glm::vec3>& points, const glm::dmat4& map)
{
    Pairs pairs;
    for (const glm::vec3& point : points) pairs.push_back({point, glm::vec3(map * glm::dvec4(point, 1))});
    return pairs;
}

/// Pairs whose images are off by up to `noise`.
inline Pairs noisy(Pairs pairs, float noise, Random& random)
{
    for (PointPair& pair : pairs) pair.image += noise * random.in_cube();
    return pairs;
}

/// How far the nearest affine map misses at most where one image lies a step off an affine map's: it follows that
/// image, and leaves the others. In [0, 1].
inline double missed_after_step(const Pairs& pairs, std::size_t moved)
{
    const auto count = static_cast<double>(pairs.size());
    glm::dvec3 mean(0);
    for (const PointPair& pair : pairs) mean += glm::dvec3(pair.point) / count;
    glm::dmat3 squares(0);
    for (const PointPair& pair : pairs)
        squares += glm::outerProduct(glm::dvec3(pair.point) - mean, glm::dvec3(pair.point) - mean);
    const glm::dvec3 pull = glm::inverse(squares) * (glm::dvec3(pairs[moved].point) - mean);
    double most = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const double follows = 1 / count + glm::dot(glm::dvec3(pairs[i].point) - mean, pull);
        most = std::max(most, std::abs((i == moved ? 1.0 : 0.0) - follows));
    }
    return most;
}

/// How far the nearest affine map misses an image at most, in one coordinate.
inline double missed_by_nearest(const Pairs& pairs)
{
    const auto count = static_cast<double>(pairs.size());
    glm::dvec3 point(0);
    glm::dvec3 image(0);
    for (const PointPair& pair : pairs) {
        point += glm::dvec3(pair.point) / count;
        image += glm::dvec3(pair.image) / count;
    }
    glm::dmat3 squares(0);
    glm::dmat3 mixed(0);
    for (const PointPair& pair : pairs) {
        squares += glm::outerProduct(glm::dvec3(pair.point) - point, glm::dvec3(pair.point) - point);
        mixed += glm::outerProduct(glm::dvec3(pair.image) - image, glm::dvec3(pair.point) - point);
    }
    const glm::dmat3 map = mixed * glm::inverse(squares);
    double most = 0;
    for (const PointPair& pair : pairs) {
        const glm::dvec3 missed = glm::abs(map * (glm::dvec3(pair.point) - point) - (glm::dvec3(pair.image) - image));
        most = std::max({most, missed.x, missed.y, missed.z});
    }
    return most;
}

/// More than anybody lays by for: 13 to 300, most of them few.
inline std::size_t many_more(Random& random)
{
    return static_cast<std::size_t>(std::exp2(random.uniform(std::log2(13.0F), std::log2(300.0F))));
}

/// Images of a box and of a few points about it, all in whole numbers, none of them rounded: an affine map, and far
/// from the origin, where a float counts whole steps only. The box's corners come first.
inline Pairs whole_and_far(Random& random)
{
    const auto whole = [&](int low, int high) {
        return static_cast<double>(low) + static_cast<double>(random.below(static_cast<std::uint32_t>(high - low + 1)));
    };
    const auto sign = [&] { return random.below(2) == 0 ? 1.0 : -1.0; };
    glm::dmat3 map;
    glm::dvec3 sides;
    glm::dvec3 here;
    glm::dvec3 there;
    const bool near_points = random.below(2) == 0;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) map[i][k] = i == k ? sign() * whole(1, 3) : whole(-2, 2);
        sides[i] = whole(1, 4);
        here[i] = near_points ? 0 : sign() * whole(1 << 18, 1 << 20);
        there[i] = sign() * whole(1 << 23, (1 << 24) - 200);
    }
    const std::uint32_t count = 9 + random.below(6);
    Pairs pairs;
    for (std::uint32_t i = 0; i < count; ++i) {
        glm::dvec3 place = sides * glm::dvec3(i & 1, i >> 1 & 1, i >> 2 & 1);
        if (i >= 8) place = glm::dvec3(glm::ivec3(4.99F * random.in_cube()));
        pairs.push_back({glm::vec3(here + place), glm::vec3(there + map * place)});
    }
    return pairs;
}

/// Images of which large parts cancel each other, in any two of the four or in all: sums of two of them are no floats.
inline std::array<glm::vec3, 4> cancelling_images(Random& random)
{
    std::array<glm::vec3, 4> images{};
    const auto large = [&] { return (random.below(2) == 0 ? 1 : -1) * random.uniform(1e5F, 1e6F); };
    for (int axis = 0; axis < 3; ++axis) {
        std::array<float, 4> terms{};  // of the sum that is 0 for affine maps
        const bool all = random.below(3) == 0;
        for (float& term : terms) term = all ? large() : random.uniform(-8, 8);
        const std::uint32_t first = random.below(4);
        const std::uint32_t second = (first + 1 + random.below(3)) % 4;
        terms[first] = large();
        double rest = (random.below(2) == 0 ? 1 : -1) * double{random.uniform(2, 8)};
        for (std::size_t k = 0; k < 4; ++k) rest += k == second ? 0 : double{terms[k]};
        terms[second] = static_cast<float>(-rest);
        for (std::size_t k = 0; k < 4; ++k) images[k][axis] = k == 1 || k == 2 ? -terms[k] : terms[k];
    }
    return images;
}

inline float extent_of(const Pairs& pairs)
{
    glm::vec3 low = pairs.front().image;
    glm::vec3 high = low;
    for (const PointPair& pair : pairs) {
        low = glm::min(low, pair.image);
        high = glm::max(high, pair.image);
    }
    const glm::vec3 sides = high - low;
    return std::max({sides.x, sides.y, sides.z});
}

}
