#include <umbral/transforms/affinity.hpp>

namespace umbral::transforms {

glm::vec3 parallelogram_defect(const std::array<glm::vec3, 4>& images)
{
    // TODO: T(p + u + v) - T(p + u) - T(p + v) + T(p).
    return not_implemented<glm::vec3>(images);
}

std::optional<glm::mat4> affine_from_points(std::span<const PointPair> pairs)
{
    // TODO: from the points' mean to the images' mean; what is left is linear. Four points first, then more.
    return not_implemented<std::optional<glm::mat4>>(pairs);
}

bool is_affine(std::span<const PointPair> pairs, float tolerance)
{
    // TODO: the map that comes nearest, and how far it misses.
    return not_implemented<bool>(pairs, tolerance);
}

}
