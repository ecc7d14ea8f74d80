// Based on: C. Ureña. Informática Gráfica, tema 1, "relación entre marcos". 2021; orientation by the determinant, with
// a filter as in J. R. Shewchuk. Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates.
// 1997.

#include <algorithm>
#include <cmath>
#include <span>
#include <umbral/transforms/frames.hpp>
#include <vector>

namespace umbral::transforms {
namespace {

/// The rows of the inverse of [x y z]: the dual basis. Each is perpendicular to two of the vectors.
glm::dmat3 dual_rows(const Frame& frame)
{
    const glm::dvec3 x(frame.x);
    const glm::dvec3 y(frame.y);
    const glm::dvec3 z(frame.z);
    return glm::dmat3(cross(y, z), cross(z, x), cross(x, y)) / dot(x, cross(y, z));
}

/// Columns from vectors of the world, the last one a difference of points, each by its dot products with the rows.
glm::mat4 coordinates(const glm::dmat3& rows, const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z,
                      const glm::dvec3& origin)
{
    const glm::dmat3 inverse = transpose(rows);
    return {glm::vec4(inverse * x, 0), glm::vec4(inverse * y, 0), glm::vec4(inverse * z, 0),
            glm::vec4(inverse * origin, 1)};
}

/// Of a number that is not 0.
int sign(double number) { return number > 0 ? 1 : -1; }

/// The sign of the exact sum: each term goes through all parts, and what a sum rounds off stays behind as a part. The
/// last that is not 0 decides.
int sign_of_sum(std::span<const double> terms)
{
    std::vector<double> parts;
    for (double term : terms) {
        for (double& part : parts) {
            const double sum = term + part;
            const double added = sum - term;
            part = (term - (sum - added)) + (part - added);
            term = sum;
        }
        parts.push_back(term);
    }
    const auto last = std::find_if(parts.rbegin(), parts.rend(), [](double part) { return part != 0; });
    return last == parts.rend() ? 0 : sign(*last);
}

/// The sign of det [x y z], exactly. A product of two floats is a double; with a third one it is the double next to it
/// and a rest, which fma gives.
int exact_sign(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z)
{
    std::vector<double> terms;
    const auto add = [&](double ab, double c) {
        terms.push_back(ab * c);
        terms.push_back(std::fma(ab, c, -terms.back()));
    };
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        add(x[i] * y[j], z[k]);
        add(-x[i] * y[k], z[j]);
    }
    return sign_of_sum(terms);
}

bool perpendicular(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::abs(dot(a, b)) <= 1e-4 * length(a) * length(b);
}

bool unit(const glm::dvec3& v) { return std::abs(length(v) - 1) <= 1e-4; }

}

glm::mat4 frame_matrix(const Frame& frame)
{
    return {glm::vec4(frame.x, 0), glm::vec4(frame.y, 0), glm::vec4(frame.z, 0), glm::vec4(frame.origin, 1)};
}

glm::mat4 inverse_of_frame(const Frame& frame)
{
    return coordinates(dual_rows(frame), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, -glm::dvec3(frame.origin));
}

glm::mat4 inverse_of_cartesian(const Frame& frame)
{
    const glm::dmat3 rows(frame.x, frame.y, frame.z);
    return coordinates(rows, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, -glm::dvec3(frame.origin));
}

// The origins are subtracted before anything rounds.
glm::mat4 between_frames(const Frame& from, const Frame& to)
{
    return coordinates(dual_rows(to), from.x, from.y, from.z, glm::dvec3(from.origin) - glm::dvec3(to.origin));
}

int orientation(const Frame& frame)
{
    const glm::dvec3 x(frame.x);
    const glm::dvec3 y(frame.y);
    const glm::dvec3 z(frame.z);
    // In double the volume is off by less than ten roundings of the product of the lengths; only in doubt is it worth
    // computing in full.
    const double volume = dot(cross(x, y), z);
    const double doubt = 1e-14 * length(x) * length(y) * length(z);
    return std::abs(volume) > doubt ? sign(volume) : exact_sign(x, y, z);
}

FrameKind classify_frame(const Frame& frame)
{
    const int side = orientation(frame);
    if (side == 0) return FrameKind::degenerate;
    const glm::dvec3 x(frame.x);
    const glm::dvec3 y(frame.y);
    const glm::dvec3 z(frame.z);
    if (!perpendicular(x, y) || !perpendicular(y, z) || !perpendicular(z, x)) return FrameKind::oblique;
    if (!unit(x) || !unit(y) || !unit(z)) return FrameKind::orthogonal;
    return side > 0 ? FrameKind::cartesian : FrameKind::orthonormal;
}

}
