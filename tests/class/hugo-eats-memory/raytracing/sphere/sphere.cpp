#include <umbral/raytracing/intersect.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    // March along the ray and remember every point, to look for the nearest one later.
    std::vector<glm::vec3> points;
    for (float t = 0;; t += 1e-8F) {
        points.push_back(ray.origin + t * ray.direction);
        if (std::abs(length(points.back() - sphere.centre) - sphere.radius) < 1e-9F) return t;
    }
}

}
