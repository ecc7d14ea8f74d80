#include <umbral/projections/frustum.hpp>

#include <cmath>
#include <stdexcept>
#include <wide.hpp>

// With 113 bits, each entry rounded to float once. The depths are found from what becomes of the two planes, the other
// entries from the half sizes and the middle of the near window.

namespace umbral::projections {
namespace {

struct Window {
    Wide middle;
    Wide half;
};

Window window_of(float low, float high) { return {(Wide(low) + high) / 2, (Wide(high) - low) / 2}; }

struct Entries {
    Window x;
    Window y;
    Wide near_plane;
    Wide depth_scale;
    Wide depth_offset;
};

// s · (-n) + o = -n and s · (-f) + o = f.
Entries entries_of(const ViewVolume& v)
{
    const bool positive = v.near_plane > 0 && v.far_plane > 0;
    if (!positive || v.left == v.right || v.bottom == v.top || v.near_plane == v.far_plane)
        throw std::invalid_argument("no frustum");
    const Wide n = v.near_plane;
    const Wide scale = std::isinf(v.far_plane) ? Wide(-1) : (n + v.far_plane) / (n - v.far_plane);
    return {window_of(v.left, v.right), window_of(v.bottom, v.top), n, scale, n * (scale - 1)};
}

}

FrustumFactors frustum_factors(const ViewVolume& volume)
{
    const Entries e = entries_of(volume);
    FrustumFactors factors{glm::mat4(1), glm::mat4(1), glm::mat4(1)};
    factors.shear[2][0] = static_cast<float>(e.x.middle / e.near_plane);
    factors.shear[2][1] = static_cast<float>(e.y.middle / e.near_plane);
    factors.scaling[0][0] = static_cast<float>(e.near_plane / e.x.half);
    factors.scaling[1][1] = static_cast<float>(e.near_plane / e.y.half);
    factors.normalization[2] = {0, 0, static_cast<float>(e.depth_scale), -1};
    factors.normalization[3] = {0, 0, static_cast<float>(e.depth_offset), 0};
    return factors;
}

glm::mat4 frustum_matrix(const ViewVolume& volume)
{
    const Entries e = entries_of(volume);
    glm::mat4 matrix(0);
    matrix[0][0] = static_cast<float>(e.near_plane / e.x.half);
    matrix[1][1] = static_cast<float>(e.near_plane / e.y.half);
    matrix[2][0] = static_cast<float>(e.x.middle / e.x.half);
    matrix[2][1] = static_cast<float>(e.y.middle / e.y.half);
    matrix[2][2] = static_cast<float>(e.depth_scale);
    matrix[2][3] = -1;
    matrix[3][2] = static_cast<float>(e.depth_offset);
    return matrix;
}

std::optional<glm::vec3> project_point(const glm::mat4& projection, const glm::vec3& point)
{
    Wide clip[4];
    for (int row = 0; row < 4; ++row) {
        clip[row] = projection[3][row];
        for (int column = 0; column < 3; ++column) clip[row] += Wide(projection[column][row]) * point[column];
    }
    if (clip[3] <= 0) return std::nullopt;
    return glm::vec3(static_cast<float>(clip[0] / clip[3]), static_cast<float>(clip[1] / clip[3]),
                     static_cast<float>(clip[2] / clip[3]));
}

}
