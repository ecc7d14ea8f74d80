// alternative: recursive, never looks at the list of lamps, directions as a point of the sphere round the normal's tip,
// and paths that end by chance from the first reflection on
#include <algorithm>
#include <cmath>
#include <umbral/raytracing/path_tracing.hpp>

namespace umbral::raytracing {

glm::vec3 cosine_direction(const glm::vec3& normal, Random& random)
{
    const glm::vec3 sum = normal + random.unit_vector();
    const float length = glm::length(sum);
    return length > 1e-6F ? sum / length : normal;
}

float cosine_density(const glm::vec3& normal, const glm::vec3& direction)
{
    const float cosine = dot(normal, direction);
    return cosine > 0 ? cosine * 0.31830989F : 0.0F;
}

float lamp_density(const glm::vec3& point, const AreaLamp& lamp, const glm::vec3& on_lamp)
{
    const glm::vec3 normal = cross(lamp.edge_a, lamp.edge_b);
    const float area = length(normal);
    const glm::vec3 to_point = point - on_lamp;
    const float cosine = std::abs(dot(normalize(to_point), normal / area));
    return dot(to_point, to_point) / (area * cosine);
}

static glm::vec3 follow(const DiffuseScene& scene, const Ray& ray, int bounces, Random& random)
{
    const auto hit = scene.first_hit(ray);
    if (!hit) return scene.sky(ray.direction);
    const float go_on = std::max(hit->albedo.x, std::max(hit->albedo.y, hit->albedo.z));
    if (bounces == 0 || random.uniform() >= go_on) return hit->emitted;
    const Ray next{hit->position, cosine_direction(hit->normal, random)};
    return hit->emitted + hit->albedo / go_on * follow(scene, next, bounces - 1, random);
}

glm::vec3 path_light(const DiffuseScene& scene, const Ray& ray, int bounces, int samples, Random& random)
{
    glm::dvec3 mean(0);
    for (int i = 1; i <= samples; ++i) {
        const glm::dvec3 light(follow(scene, ray, bounces, random));
        mean += (light - mean) / static_cast<double>(i);
    }
    return glm::vec3(mean);
}

}
