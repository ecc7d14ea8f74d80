#include <umbral/lighting/brightest_point.hpp>

namespace umbral::lighting {

glm::vec3 brightest_diffuse(const Sphere& sphere, const Light& light)
{
    // TODO: from the centre straight towards the light, as far as the radius.
    return not_implemented<glm::vec3>(sphere, light);
}

bool is_seen(const Sphere& sphere, const glm::vec3& point, const glm::vec3& eye)
{
    // TODO: whether the eye is in front of the tangent plane at the point.
    return not_implemented<bool>(sphere, point, eye);
}

std::optional<glm::vec3> brightest_seen(const Sphere& sphere, const Light& light, const glm::vec3& eye)
{
    // TODO: the brightest point of all, if it is seen; otherwise the point of the horizon that is nearest to it, if
    // any light arrives there.
    return not_implemented<std::optional<glm::vec3>>(sphere, light, eye);
}

std::optional<glm::vec3> brightest_specular(const Sphere& sphere, const Light& light, const glm::vec3& eye)
{
    // TODO: between the points below the light and below the eye, search for the one whose normal makes the same angle
    // with both.
    return not_implemented<std::optional<glm::vec3>>(sphere, light, eye);
}

}
