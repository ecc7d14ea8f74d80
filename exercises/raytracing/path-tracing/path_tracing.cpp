#include <umbral/raytracing/path_tracing.hpp>

namespace umbral::raytracing {

glm::vec3 cosine_direction(const glm::vec3& normal, Random& random)
{
    // TODO: a unit direction on the side of the normal, denser near it: cos(theta) / pi per steradian.
    return not_implemented<glm::vec3>(normal, random);
}

float cosine_density(const glm::vec3& normal, const glm::vec3& direction)
{
    // TODO: that density at a direction.
    return not_implemented<float>(normal, direction);
}

float lamp_density(const glm::vec3& point, const AreaLamp& lamp, const glm::vec3& on_lamp)
{
    // TODO: the density per steradian of the direction to a place drawn uniformly over the lamp's area.
    return not_implemented<float>(point, lamp, on_lamp);
}

glm::vec3 path_light(const DiffuseScene& scene, const Ray& ray, int bounces, int samples, Random& random)
{
    // TODO: the mean of `samples` paths. Each follows the ray to the first surface, adds what shines there, and goes on
    // in a random direction, with the share of the light that is left, until `bounces` reflections or chance end it.
    return not_implemented<glm::vec3>(scene, ray, bounces, samples, random);
}

}
