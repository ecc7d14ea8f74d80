#include <umbral/transforms/frames.hpp>

#include "wide_vector.hpp"

// In __float128, by Cramer's rule with cofactors; rounded to float once.

namespace umbral::transforms {
namespace {

Wide determinant(const WideVector& a, const WideVector& b, const WideVector& c)
{
    return a[0] * b[1] * c[2] + b[0] * c[1] * a[2] + c[0] * a[1] * b[2] - c[0] * b[1] * a[2] - a[0] * c[1] * b[2] -
           b[0] * a[1] * c[2];
}

/// The coordinates of a vector of the world: v = a x + b y + c z.
glm::vec4 coordinates(const Frame& frame, const WideVector& v, float w)
{
    const WideVector x = widened(frame.x);
    const WideVector y = widened(frame.y);
    const WideVector z = widened(frame.z);
    const Wide all = determinant(x, y, z);
    return {static_cast<float>(determinant(v, y, z) / all), static_cast<float>(determinant(x, v, z) / all),
            static_cast<float>(determinant(x, y, v) / all), w};
}

bool perpendicular(const WideVector& a, const WideVector& b)
{
    return dot(a, b) * dot(a, b) <= Wide(1e-8) * dot(a, a) * dot(b, b);
}

// | |v| - 1 | ≤ 1e-4, of squares.
bool is_unit(const WideVector& v) { return absolute(dot(v, v) - Wide(1 + 1e-8)) <= Wide(2e-4); }

}

glm::mat4 frame_matrix(const Frame& frame)
{
    glm::mat4 result(1);
    for (int row = 0; row < 3; ++row) {
        result[0][row] = frame.x[row];
        result[1][row] = frame.y[row];
        result[2][row] = frame.z[row];
        result[3][row] = frame.origin[row];
    }
    return result;
}

glm::mat4 between_frames(const Frame& from, const Frame& to)
{
    return {coordinates(to, widened(from.x), 0), coordinates(to, widened(from.y), 0),
            coordinates(to, widened(from.z), 0), coordinates(to, widened(from.origin) - widened(to.origin), 1)};
}

glm::mat4 inverse_of_frame(const Frame& frame)
{
    return between_frames({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}, frame);
}

glm::mat4 inverse_of_cartesian(const Frame& frame)
{
    glm::mat4 result(1);
    const glm::vec3* axes[] = {&frame.x, &frame.y, &frame.z};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) result[column][row] = (*axes[row])[column];
        result[3][row] = static_cast<float>(-dot(widened(*axes[row]), widened(frame.origin)));
    }
    return result;
}

int orientation(const Frame& frame)
{
    const Wide volume = determinant(widened(frame.x), widened(frame.y), widened(frame.z));
    return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

FrameKind classify_frame(const Frame& frame)
{
    const WideVector x = widened(frame.x);
    const WideVector y = widened(frame.y);
    const WideVector z = widened(frame.z);
    const int side = orientation(frame);
    if (side == 0) return FrameKind::degenerate;
    if (!perpendicular(x, y) || !perpendicular(y, z) || !perpendicular(z, x)) return FrameKind::oblique;
    if (!is_unit(x) || !is_unit(y) || !is_unit(z)) return FrameKind::orthogonal;
    return side > 0 ? FrameKind::cartesian : FrameKind::orthonormal;
}

}
