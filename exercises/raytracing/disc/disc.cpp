#include <umbral/raytracing/disc.hpp>

namespace umbral::raytracing {

std::optional<float> intersect(const Ray& ray, const Disc& disc)
{
    // TODO: find the t at which the ray meets the plane of the disc: there, origin + t * direction - centre is
    // perpendicular to the normal. Return it if it lies strictly between ray.t_min and ray.t_max and the point is
    // nearer to the centre than the radius, or std::nullopt otherwise.
    return not_implemented<std::optional<float>>(ray, disc);
}

}
