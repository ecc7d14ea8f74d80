#pragma once

#include <algorithm>
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
