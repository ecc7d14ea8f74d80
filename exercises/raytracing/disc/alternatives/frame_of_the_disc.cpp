// alternative: moves the ray to a frame in which the disc is that of radius 1 in the plane z = 0
#include <cmath>
#include <umbral/raytracing/disc.hpp>

namespace umbral::raytracing {
namespace {

struct Frame {
    glm::dvec3 x, y, z;
};

Frame frame_round(const glm::dvec3& z)
{
    const glm::dvec3 axis = std::abs(z.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = normalize(cross(axis, z));
    return {x, cross(z, x), z};
}

}

std::optional<float> intersect(const Ray& ray, const Disc& disc)
{
    if (disc.normal == glm::vec3(0)) return std::nullopt;
    const Frame frame = frame_round(normalize(glm::dvec3(disc.normal)));
    const auto moved = [&](const glm::dvec3& v) {
        return glm::dvec3(dot(v, frame.x), dot(v, frame.y), dot(v, glm::dvec3(disc.normal))) / double{disc.radius};
    };
    const glm::dvec3 origin = moved(glm::dvec3(ray.origin) - glm::dvec3(disc.centre));
    const glm::dvec3 direction = moved(ray.direction);
    const double t = -origin.z / direction.z;
    if (!std::isfinite(t) || !(t > ray.t_min) || !(t < ray.t_max)) return std::nullopt;
    const glm::dvec2 place = glm::dvec2(origin) + t * glm::dvec2(direction);
    if (place.x * place.x + place.y * place.y >= 1) return std::nullopt;
    return static_cast<float>(t);
}

}
