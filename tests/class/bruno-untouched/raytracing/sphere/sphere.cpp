#include <umbral/raytracing/intersect.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Sphere& sphere)
{
    // TODO: substitute the ray's point origin + t * direction into |p - centre|² = radius² and solve for t.
    // Return the smallest t strictly between ray.t_min and ray.t_max, or std::nullopt if there is none.
    return not_implemented<std::optional<float>>(ray, sphere);
}

}
