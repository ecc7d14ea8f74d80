// Based on: O. Rodrigues. Des lois géométriques qui régissent les déplacements d'un système solide dans l'espace. 1840,
// as the course gives it: s' = cosθ s + (1 - cosθ)(s·e) e + sinθ e × s; and, for chains, W. R. Hamilton. On
// Quaternions. 1844: of a product of quaternions only the length can stray from a rotation's.

#include <cmath>
#include <umbral/transforms/rotation.hpp>

namespace umbral::transforms {
namespace {

/// A turn as a unit quaternion: the cosine of half the angle, and the axis times the sine of it.
struct Quaternion {
    double scalar = 1;
    glm::dvec3 vector{0};
};

bool finite(const AxisAngle& turn)
{
    return std::isfinite(turn.axis.x) && std::isfinite(turn.axis.y) && std::isfinite(turn.axis.z) &&
           std::isfinite(turn.angle);
}

// In double, the square of no float's length overflows or underflows, and the sine and cosine of half a tiny angle keep
// all their digits.
Quaternion quaternion(const AxisAngle& turn)
{
    const glm::dvec3 axis(turn.axis);
    const double size = length(axis);
    if (size == 0 || !finite(turn)) return {};
    const double half = 0.5 * double{turn.angle};
    return {std::cos(half), std::sin(half) / size * axis};
}

/// The turn `second` after the turn `first`.
Quaternion after(const Quaternion& second, const Quaternion& first)
{
    return {second.scalar * first.scalar - dot(second.vector, first.vector),
            second.scalar * first.vector + first.scalar * second.vector + cross(second.vector, first.vector)};
}

/// (1 - cosθ) e eᵀ + cosθ I + sinθ [e]×, by the half angle: 1 - cosθ = 2 sin²(θ/2) and sinθ = 2 sin(θ/2) cos(θ/2),
/// which cancel nothing.
glm::mat4 matrix(const Quaternion& turn)
{
    const auto& [w, v] = turn;
    const double x = v.x;
    const double y = v.y;
    const double z = v.z;
    return glm::mat4(glm::dmat4(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0,  //
                                2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0,  //
                                2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), 0,  //
                                0, 0, 0, 1));
}

}

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn)
{
    const auto [w, v] = quaternion(turn);
    const glm::dvec3 s(vector);
    // s' = s + sinθ e × s + (1 - cosθ) e × (e × s), each sine and cosine by the half angle.
    const glm::dvec3 aside = 2.0 * cross(v, s);
    return glm::vec3(s + w * aside + cross(v, aside));
}

glm::mat4 rotation_matrix(const AxisAngle& turn) { return matrix(quaternion(turn)); }

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    Quaternion all;
    for (const AxisAngle& turn : turns) {
        all = after(quaternion(turn), all);
        // Its length strays from 1 by a rounding a turn; taken back at once, by one step of Newton's method for 1/√x at
        // x = 1.
        const double correction = 1.5 - 0.5 * (all.scalar * all.scalar + dot(all.vector, all.vector));
        all = {correction * all.scalar, correction * all.vector};
    }
    return matrix(all);
}

}
