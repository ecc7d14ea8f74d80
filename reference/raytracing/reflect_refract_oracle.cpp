#include <cmath>
#include <umbral/raytracing/reflect_refract.hpp>

#include "wide_vector.hpp"

// The course's formulas with 113 bits, for directions made unit, rounded to float once.

namespace umbral::raytracing {
namespace {

WideVector unit(const glm::vec3& v) { return umbral::unit(widened(v)); }

}

glm::vec3 mirrored_direction(const glm::vec3& v, const glm::vec3& n)
{
    const WideVector i = unit(v);
    const WideVector normal = unit(n);
    return rounded((2 * dot(i, normal)) * normal - i);
}

std::optional<glm::vec3> refracted_direction(const glm::vec3& v, const glm::vec3& n, float outside, float inside)
{
    const WideVector i = unit(v);
    const bool enters = dot(i, unit(n)) >= 0;
    const WideVector normal = Wide{enters ? 1.0F : -1.0F} * unit(n);
    const Wide r = enters ? Wide{outside} / Wide{inside} : Wide{inside} / Wide{outside};
    const Wide c = dot(i, normal);
    const Wide k = 1 - r * r * (1 - c * c);
    if (k < 0) return std::nullopt;
    return rounded((r * c - square_root(k)) * normal - r * i);
}

std::optional<float> critical_angle(float from, float into)
{
    if (!(into < from)) return std::nullopt;
    const Wide sine = Wide{into} / Wide{from};
    return static_cast<float>(
        std::atan2(static_cast<long double>(sine), static_cast<long double>(square_root((1 - sine) * (1 + sine)))));
}

}
