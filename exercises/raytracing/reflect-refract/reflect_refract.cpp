#include <umbral/raytracing/reflect_refract.hpp>

namespace umbral::raytracing {

glm::vec3 mirrored_direction(const glm::vec3& v, const glm::vec3& n)
{
    // TODO: make both unit. The part of v along n stays, and the part across it changes its sign.
    return not_implemented<glm::vec3>(v, n);
}

std::optional<glm::vec3> refracted_direction(const glm::vec3& v, const glm::vec3& n, float outside, float inside)
{
    // TODO: which side does the ray come from? Turn n to that side, and take r as the index there over the other one.
    // Then t = (r cos(i) - cos(t)) n - r v, with cos(t)² = 1 - r² (1 - cos(i)²); none if that is negative.
    return not_implemented<std::optional<glm::vec3>>(v, n, outside, inside);
}

std::optional<float> critical_angle(float from, float into)
{
    // TODO: the angle of incidence for which the refracted ray runs along the surface.
    return not_implemented<std::optional<float>>(from, into);
}

}
