#pragma once

#include <cmath>
#include <kit/shapes.hpp>
#include <optional>
#include <umbral/raytracing/triangle.hpp>
#include <vector>

#include "../rays.hpp"

/// Rays aimed at triangles so that the answer is known.
namespace umbral::raytracing {

/// One question put to a ray-triangle intersection.
struct TriangleShot {
    Ray ray;
    Triangle triangle;
};

/// A triangle with corners in a cube of side 2 somewhere near the origin, none of whose heights is under 0.3.
inline Triangle random_triangle(Random& random)
{
    const glm::dvec3 centre(3.0F * random.in_cube());
    const glm::dvec3 normal(random.unit_vector());
    const glm::dvec3 x = perpendicular_to(normal, random);
    const glm::dvec3 y = cross(normal, x);
    const auto corner = [&](double turn) {
        const double angle = 6.283185307 * (turn + 0.2 * random.uniform_double());
        return glm::vec3(centre + double{random.uniform(0.5F, 1.5F)} * (std::cos(angle) * x + std::sin(angle) * y));
    };
    const glm::vec3 v0 = corner(0);
    const glm::vec3 v1 = corner(1.0 / 3);
    const Triangle triangle{v0, v1, corner(2.0 / 3)};
    return random.below(2) == 0 ? triangle : Triangle{triangle.v0, triangle.v2, triangle.v1};
}

inline glm::dvec3 point_of(const Triangle& triangle, double a, double b)
{
    return (1 - a - b) * glm::dvec3(triangle.v0) + a * glm::dvec3(triangle.v1) + b * glm::dvec3(triangle.v2);
}

/// A ray of unit direction that meets the triangle's plane at (a, b), with this sine of its angle with the plane, from
/// a side and direction that are random.
inline TriangleShot aimed(const Triangle& triangle, double a, double b, double sine, double distance, Random& random)
{
    const glm::dvec3 normal = normalize(
        cross(glm::dvec3(triangle.v1) - glm::dvec3(triangle.v0), glm::dvec3(triangle.v2) - glm::dvec3(triangle.v0)));
    const double side = random.below(2) == 0 ? sine : -sine;
    const glm::dvec3 from = side * normal + std::sqrt(1 - sine * sine) * perpendicular_to(normal, random);
    return {aimed_at(point_of(triangle, a, b), from, distance), triangle};
}

/// `count` pairs from 2 to 8 away with sines in a range: hits keep `margin` from each edge in barycentric coordinates,
/// and misses lie that far beyond one of them at least, or beyond two.
inline std::vector<TriangleShot> random_pairs(Random& random, int count, double least_sine, double largest_sine,
                                              double margin)
{
    std::vector<TriangleShot> shots;
    for (int i = 0; i < count; ++i) {
        const Triangle triangle = random_triangle(random);
        const double sine = least_sine * std::pow(largest_sine / least_sine, random.uniform_double());
        const double distance = random.uniform(2, 8);
        const double u = std::sqrt(random.uniform_double());
        const double v = random.uniform_double();
        const double inside = 1 - 3 * margin;
        const TriangleShot hit =
            aimed(triangle, margin + inside * (1 - u), margin + inside * u * v, sine, distance, random);
        const double beyond = margin + 0.5 * random.uniform_double();
        const double along = random.uniform(-0.2F, 1.2F);
        const double places[3][2] = {{-beyond, along}, {along, -beyond}, {along, 1 + beyond - along}};
        const TriangleShot miss = aimed(triangle, places[i % 3][0], places[i % 3][1], sine, distance, random);
        add_pair(shots, hit, miss, random);
    }
    return shots;
}

/// A closed ball of 320 triangles with a bumpy surface, round the origin.
inline std::vector<Triangle> bumpy_ball()
{
    const shapes::Shape ball = shapes::icosphere(2);
    const auto place = [&](std::size_t i) {
        const glm::vec3 p = normalize(ball.positions[ball.indices[i]]);
        return p * (1 + 0.09F * std::sin(5 * p.x + 1) * std::cos(4 * p.y) + 0.06F * std::sin(7 * p.z + 2 * p.y));
    };
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < ball.indices.size(); i += 3)
        triangles.push_back({place(i), place(i + 1), place(i + 2)});
    return triangles;
}

}
