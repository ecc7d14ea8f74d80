#pragma once

#include <glm/glm.hpp>
#include <umbral/core/random.hpp>
#include <vector>

namespace umbral::bench {

/// The points p with normal · p < offset, seen through a pixel: the unit square.
struct HalfPlane {
    glm::dvec2 normal;
    double offset;
    [[nodiscard]] bool covers(const glm::dvec2& p) const { return normal.x * p.x + normal.y * p.y < offset; }
};

/// The covered area of the unit square, in closed form; no component of the normal is 0.
[[nodiscard]] double covered_area(const HalfPlane& edge);

/// An edge through a uniform point of the pixel, whose normal has an angle in [low, high) radians.
[[nodiscard]] HalfPlane random_edge(Random& random, double low, double high);

/// The share of the samples that an edge covers.
[[nodiscard]] double covered_share(const HalfPlane& edge, const std::vector<glm::dvec2>& samples);

/// The first `count` points of Hammersley's set, moved by `shift` round the unit square.
[[nodiscard]] std::vector<glm::dvec2> hammersley(int count, const glm::dvec2& shift);

/// The middles of n x n equal cells, n² = count; with `random` a point of each instead.
[[nodiscard]] std::vector<glm::dvec2> cells(int count, Random* random);

/// `count` independent uniform points.
[[nodiscard]] std::vector<glm::dvec2> independent(int count, Random& random);

}
