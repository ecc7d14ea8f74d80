// alternative: what runs along the surface is kept, and the rest follows from the length (long double); a mirror
// matrix
#include <cmath>
#include <umbral/raytracing/reflect_refract.hpp>

namespace umbral::raytracing {
namespace {

using Exact = glm::vec<3, long double>;
using Matrix = glm::mat<3, 3, long double>;

}

glm::vec3 mirrored_direction(const glm::vec3& v, const glm::vec3& n)
{
    const Exact normal(n);
    const Matrix mirror = Matrix(2 / dot(normal, normal) * outerProduct(normal, normal)) - Matrix(1);
    return glm::vec3(normalize(mirror * Exact(v)));
}

std::optional<glm::vec3> refracted_direction(const glm::vec3& v, const glm::vec3& n, float outside, float inside)
{
    const Exact normal = normalize(Exact(n));
    long double from = outside;
    long double into = inside;
    const bool leaves = dot(Exact(v), normal) < 0;
    if (leaves) std::swap(from, into);
    const Exact wave = -from * normalize(Exact(v));
    const Exact kept = cross(normal, cross(wave, normal));
    const long double rest = into * into - dot(kept, kept);
    if (rest < 0) return std::nullopt;
    const Exact onwards = kept + (leaves ? 1 : -1) * std::sqrt(rest) * normal;
    return glm::vec3(onwards / into);
}

std::optional<float> critical_angle(float from, float into)
{
    std::optional<float> angle;
    if (into < from) angle = std::asin(static_cast<long double>(into) / from);
    return angle;
}

}
