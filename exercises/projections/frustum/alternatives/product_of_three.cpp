// alternative: the factors first, in double, and the matrix as their product
#include <limits>
#include <stdexcept>
#include <umbral/projections/frustum.hpp>

namespace umbral::projections {
namespace {

struct WideFactors {
    glm::dmat4 shear{1.0};
    glm::dmat4 scaling{1.0};
    glm::dmat4 normalization{1.0};
};

WideFactors factors_of(const ViewVolume& v)
{
    const bool has_size = v.right != v.left && v.top != v.bottom && v.far_plane != v.near_plane;
    if (!has_size || !(v.near_plane > 0 && v.far_plane > 0)) throw std::invalid_argument("this is no frustum");
    const double n = v.near_plane;
    const double f = v.far_plane;
    WideFactors factors;
    factors.shear[2][0] = (double{v.right} + v.left) / (2 * n);
    factors.shear[2][1] = (double{v.top} + v.bottom) / (2 * n);
    factors.scaling[0][0] = 2 * n / (double{v.right} - v.left);
    factors.scaling[1][1] = 2 * n / (double{v.top} - v.bottom);
    const bool endless = v.far_plane == std::numeric_limits<float>::infinity();
    factors.normalization[2][2] = endless ? -1 : -(f + n) / (f - n);
    factors.normalization[3][2] = endless ? -2 * n : -2 * f * n / (f - n);
    factors.normalization[2][3] = -1;
    factors.normalization[3][3] = 0;
    return factors;
}

}

FrustumFactors frustum_factors(const ViewVolume& volume)
{
    const WideFactors factors = factors_of(volume);
    return {glm::mat4(factors.shear), glm::mat4(factors.scaling), glm::mat4(factors.normalization)};
}

glm::mat4 frustum_matrix(const ViewVolume& volume)
{
    const WideFactors factors = factors_of(volume);
    return glm::mat4(factors.normalization * factors.scaling * factors.shear);
}

std::optional<glm::vec3> project_point(const glm::mat4& projection, const glm::vec3& point)
{
    glm::dvec4 clip(0);
    for (int column = 0; column < 4; ++column)
        clip += glm::dvec4(projection[column]) * double{column < 3 ? point[column] : 1.0F};
    if (clip.w <= 0) return {};
    return glm::vec3(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
}

}
