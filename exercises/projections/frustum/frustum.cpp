#include <umbral/projections/frustum.hpp>

namespace umbral::projections {

glm::mat4 frustum_matrix(const ViewVolume& volume)
{
    // TODO: similar triangles give x' = x n / -z in the near window, and that goes to [-1, 1]. What makes z = -near of
    // z, after division by w = -z, into -1, and z = -far into 1? Mind an infinite far plane, and what is no frustum.
    return not_implemented<glm::mat4>(volume);
}

FrustumFactors frustum_factors(const ViewVolume& volume)
{
    // TODO: shear until the frustum is symmetric, scale x and y, then normalise z.
    return not_implemented<FrustumFactors>(volume);
}

std::optional<glm::vec3> project_point(const glm::mat4& projection, const glm::vec3& point)
{
    // TODO: clip coordinates, then the division by w. Not every point can be shown.
    return not_implemented<std::optional<glm::vec3>>(projection, point);
}

}
