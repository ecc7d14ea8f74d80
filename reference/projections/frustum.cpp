// Based on: the course's matrix Q and its factors P = N S H; J. Foley, A. van Dam, S. Feiner, J. Hughes. Computer
// Graphics: Principles and Practice. 1990, 6.5. Infinite far plane: C. Everitt, M. Kilgard. Practical and robust
// stenciled shadow volumes. 2002.

#include <umbral/projections/frustum.hpp>

#include <cmath>
#include <stdexcept>

namespace umbral::projections {
namespace {

/// What the depths of a frustum become: z' = scale · z + offset, w' = -z.
struct Depth {
    double scale;
    double offset;
};

// With the quotient n/f instead of f: it is 0 for an infinite far plane.
Depth depth_of(const ViewVolume& volume)
{
    const double n = volume.near_plane;
    const double quotient = n / volume.far_plane;
    return {-(1 + quotient) / (1 - quotient), -2 * n / (1 - quotient)};
}

void require_frustum(const ViewVolume& v)
{
    if (v.left == v.right || v.bottom == v.top || v.near_plane == v.far_plane)
        throw std::invalid_argument("opposite sides of a frustum differ");
    if (!(v.near_plane > 0) || !(v.far_plane > 0))
        throw std::invalid_argument("the planes of a frustum lie before the eye");
}

}

FrustumFactors frustum_factors(const ViewVolume& volume)
{
    require_frustum(volume);
    const auto [l, r, b, t, n, f] = volume;
    FrustumFactors factors{glm::mat4(1), glm::mat4(1), glm::mat4(1)};

    // The middle of the near window is ((l + r) / 2, (b + t) / 2, -n).
    factors.shear[2][0] = static_cast<float>((double{l} + r) / (2.0 * n));
    factors.shear[2][1] = static_cast<float>((double{b} + t) / (2.0 * n));

    factors.scaling[0][0] = static_cast<float>(2.0 * n / (double{r} - l));
    factors.scaling[1][1] = static_cast<float>(2.0 * n / (double{t} - b));

    const Depth depth = depth_of(volume);
    factors.normalization[2] = {0, 0, depth.scale, -1};
    factors.normalization[3] = {0, 0, depth.offset, 0};
    return factors;
}

// Not the product of the factors above: those are rounded already.
glm::mat4 frustum_matrix(const ViewVolume& volume)
{
    require_frustum(volume);
    const double l = volume.left;
    const double r = volume.right;
    const double b = volume.bottom;
    const double t = volume.top;
    const double n = volume.near_plane;
    const Depth depth = depth_of(volume);
    return {{2 * n / (r - l), 0, 0, 0},
            {0, 2 * n / (t - b), 0, 0},
            {(r + l) / (r - l), (t + b) / (t - b), depth.scale, -1},
            {0, 0, depth.offset, 0}};
}

// In double: off the axis, x and z of a narrow frustum have large terms that nearly cancel.
std::optional<glm::vec3> project_point(const glm::mat4& projection, const glm::vec3& point)
{
    const glm::dvec4 clip = glm::dmat4(projection) * glm::dvec4(point, 1);
    if (!(clip.w > 0)) return std::nullopt;
    return glm::vec3(glm::dvec3(clip) / clip.w);
}

}
