// Based on: T. Whitted. An Improved Illumination Model for Shaded Display. Communications of the ACM 23(6), 1980.

#include <umbral/raytracing/whitted.hpp>

namespace umbral::raytracing::whitted {
namespace {

/// A unit vector to a light, and how far away it is.
struct WayToLight {
    glm::vec3 direction;
    float distance;
};

WayToLight way_to(const lighting::Light& light, const glm::vec3& position)
{
    const glm::vec3 place(light.position);
    if (light.position.w == 0) return {normalize(place), std::numeric_limits<float>::infinity()};
    return {normalize(place - position), distance(place, position)};
}

/// Where v goes on behind a surface whose normal n is on its side; q is the index on that side over the other one.
std::optional<glm::vec3> refracted(const glm::vec3& v, const glm::vec3& n, float q)
{
    const float cosine = dot(n, v);
    const float squared_cosine_behind = 1 - q * q * (1 - cosine * cosine);
    if (squared_cosine_behind < 0) return std::nullopt;
    return (q * cosine - std::sqrt(squared_cosine_behind)) * n - q * v;
}

}

glm::vec3 direct_light(const lighting::Material& material, const glm::vec3& normal, const glm::vec3& v,
                       const glm::vec3& l)
{
    const float facing = dot(normal, l);
    if (facing <= 0) return material.ambient;
    const glm::vec3 mirrored = 2 * facing * normal - l;
    const float highlight = std::pow(std::max(0.0F, dot(mirrored, v)), material.shininess);
    return material.ambient + facing * material.diffuse + highlight * material.specular;
}

glm::vec3 light_towards(const World& world, const Hit& hit, const glm::vec3& v, int level)
{
    const bool inside = dot(hit.normal, v) < 0;
    const glm::vec3 n = inside ? -hit.normal : hit.normal;
    lighting::Material local = hit.material.local;
    if (hit.material.texture != 0) {
        const glm::vec3 color = world.texture_color(hit.material.texture, hit.uv);
        local.ambient *= color;
        local.diffuse *= color;
    }

    glm::vec3 light = local.emission + world.ambient();
    for (const lighting::Light& source : world.lights()) {
        const WayToLight way = way_to(source, hit.position);
        if (!world.first_hit(Ray{hit.position, way.direction, clearance, way.distance}))
            light += source.color * direct_light(local, n, v, way.direction);
    }

    if (level >= world.max_level()) return light;
    const auto light_from = [&](const glm::vec3& direction) {
        return light_along(world, Ray{hit.position, direction, clearance}, level + 1);
    };
    if (hit.material.mirrored > 0)
        light += hit.material.mirrored * hit.material.mirrored_color * light_from(2 * dot(n, v) * n - v);
    if (hit.material.refracted > 0) {
        const float q = inside ? hit.material.index : 1 / hit.material.index;
        if (const std::optional<glm::vec3> t = refracted(v, n, q))
            light += hit.material.refracted * hit.material.refracted_color * light_from(*t);
    }
    return light;
}

glm::vec3 light_along(const World& world, const Ray& ray, int level)
{
    if (level > world.max_level()) return glm::vec3(0);
    const std::optional<Hit> hit = world.first_hit(ray);
    return hit ? light_towards(world, *hit, -ray.direction, level) : world.background(ray.direction);
}

}
