#include <cassert>
#include <umbral/raytracing/intersect.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    std::printf("direction has length %g\n", static_cast<double>(length(ray.direction)));
    assert(length(ray.direction) < 1 && "direction must be shorter than 1");
    return ray.origin.x - sphere.radius;
}

}
