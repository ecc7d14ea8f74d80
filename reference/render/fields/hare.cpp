#include <algorithm>
#include <array>
#include <cmath>

#include "render/fields/shapes.hpp"

namespace umbral::render::fields {
namespace {

/// The hull of two balls, and over which distance it flows into what stands before it in the list.
struct Part {
    glm::dvec3 from;
    double from_radius;
    glm::dvec3 to;
    double to_radius;
    double join;
};

/// The distance from the hull of two balls: I. Quilez's round cone.
double round_cone(const glm::dvec3& place, const Part& part)
{
    const glm::dvec3 axis = part.to - part.from;
    const double axis2 = dot(axis, axis);
    const double narrowing = part.from_radius - part.to_radius;
    const double side2 = axis2 - narrowing * narrowing;
    const glm::dvec3 from = place - part.from;
    const double along = dot(from, axis);
    const double beyond = along - axis2;
    const glm::dvec3 off_axis = from * axis2 - axis * along;
    const double across2 = dot(off_axis, off_axis);
    const double along2 = along * along * axis2;
    const double beyond2 = beyond * beyond * axis2;
    const double k = std::copysign(narrowing * narrowing * across2, narrowing);
    if (std::copysign(side2 * beyond2, beyond) > k) return std::sqrt(across2 + beyond2) / axis2 - part.to_radius;
    if (std::copysign(side2 * along2, along) < k) return std::sqrt(across2 + along2) / axis2 - part.from_radius;
    return (std::sqrt(across2 * side2 / axis2) + along * narrowing) / axis2 - part.from_radius;
}

/// The smaller of two, without an edge where they are nearly equal: I. Quilez's cubic. It keeps what Distance promises,
/// as its slopes by a and b are shares of 1.
double smooth_minimum(double a, double b, double join)
{
    const double h = std::max(0.0, join - std::abs(a - b)) / join;
    return std::min(a, b) - h * h * h * join / 6;
}

/// The right half, z >= 0, with what lies in the middle.
const std::array<Part, 15> parts = {{
    {{-0.30, -0.44, 0}, 0.40, {0.10, -0.14, 0}, 0.29, 0.1},             // trunk
    {{0.10, -0.20, 0}, 0.27, {0.27, 0.16, 0}, 0.165, 0.16},             // chest and neck
    {{0.29, 0.30, 0}, 0.185, {0.50, 0.215, 0}, 0.105, 0.1},             // head
    {{0.555, 0.215, 0}, 0.062, {0.575, 0.20, 0}, 0.06, 0.05},           // nose
    {{0.40, 0.215, 0.075}, 0.105, {0.45, 0.19, 0.06}, 0.09, 0.06},      // cheek
    {{0.24, 0.42, 0.075}, 0.05, {0.10, 0.66, 0.135}, 0.064, 0.06},      // ear
    {{0.10, 0.66, 0.135}, 0.064, {-0.05, 0.90, 0.17}, 0.032, 0.06},     // its tip
    {{0.445, 0.335, 0.1}, 0.036, {0.45, 0.335, 0.102}, 0.036, 0.012},   // eye
    {{-0.27, -0.50, 0.24}, 0.25, {-0.04, -0.66, 0.28}, 0.15, 0.07},     // thigh
    {{-0.28, -0.85, 0.29}, 0.10, {0.16, -0.875, 0.31}, 0.075, 0.07},    // hind foot
    {{0.20, -0.22, 0.12}, 0.13, {0.30, -0.58, 0.13}, 0.075, 0.1},       // shoulder and arm
    {{0.30, -0.58, 0.13}, 0.075, {0.345, -0.86, 0.12}, 0.066, 0.05},    // forearm
    {{0.345, -0.875, 0.12}, 0.072, {0.44, -0.885, 0.12}, 0.064, 0.05},  // paw
    {{-0.70, -0.56, 0}, 0.12, {-0.74, -0.50, 0}, 0.10, 0.06},           // tail
    {{-0.50, -0.72, 0.10}, 0.16, {-0.30, -0.76, 0.15}, 0.17, 0.15},     // what it sits on
}};

}

double hare(const glm::dvec3& place)
{
    const glm::dvec3 half(place.x, place.y, std::abs(place.z));
    double distance = round_cone(half, parts[0]);
    for (std::size_t i = 1; i < parts.size(); ++i)
        distance = smooth_minimum(distance, round_cone(half, parts[i]), parts[i].join);
    return distance;
}

}
