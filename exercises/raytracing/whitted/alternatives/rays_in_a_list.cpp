// alternative: keeps a list of rays with their weights instead of calling itself, and sends shadow rays without end
#include <umbral/raytracing/whitted.hpp>
#include <vector>

namespace umbral::raytracing::whitted {
namespace {

struct Weighted {
    Ray ray;
    int level;
    glm::vec3 weight;
};

// What the surface sends by itself; rays that it asks for go to the list.
glm::vec3 visit(const World& world, const Hit& hit, const glm::vec3& v, int level, const glm::vec3& weight,
                std::vector<Weighted>& list)
{
    const float side = dot(hit.normal, v) < 0 ? -1.0F : 1.0F;
    const glm::vec3 n = side * hit.normal;
    lighting::Material m = hit.material.local;
    const glm::vec3 paint =
        hit.material.texture == 0 ? glm::vec3(1) : world.texture_color(hit.material.texture, hit.uv);
    m.ambient = m.ambient * paint;
    m.diffuse = m.diffuse * paint;
    glm::vec3 sum = m.emission + world.ambient();
    for (const lighting::Light& light : world.lights()) {
        const bool sun = light.position.w == 0;
        const glm::vec3 to_light = sun ? glm::vec3(light.position) : glm::vec3(light.position) - hit.position;
        Ray probe;
        probe.origin = hit.position;
        probe.direction = glm::normalize(to_light);
        probe.t_min = clearance;
        const std::optional<Hit> first = world.first_hit(probe);
        if (first && (sun || first->t < glm::length(to_light))) continue;
        sum = sum + light.color * direct_light(m, n, v, probe.direction);
    }
    if (level + 1 <= world.max_level()) {
        if (hit.material.mirrored > 0)
            list.push_back({Ray{hit.position, glm::reflect(-v, n), clearance}, level + 1,
                            weight * hit.material.mirrored_color * hit.material.mirrored});
        if (hit.material.refracted > 0) {
            const float eta = side > 0 ? 1.0F / hit.material.index : hit.material.index;
            const glm::vec3 t = glm::refract(-v, n, eta);
            if (t != glm::vec3(0))
                list.push_back({Ray{hit.position, t, clearance}, level + 1,
                                weight * hit.material.refracted_color * hit.material.refracted});
        }
    }
    return weight * sum;
}

glm::vec3 work_off(const World& world, std::vector<Weighted> list)
{
    glm::vec3 sum(0);
    while (!list.empty()) {
        const Weighted next = list.back();
        list.pop_back();
        if (next.level > world.max_level()) continue;
        const std::optional<Hit> hit = world.first_hit(next.ray);
        if (hit)
            sum += visit(world, *hit, -next.ray.direction, next.level, next.weight, list);
        else
            sum += next.weight * world.background(next.ray.direction);
    }
    return sum;
}

}

glm::vec3 direct_light(const lighting::Material& material, const glm::vec3& normal, const glm::vec3& v,
                       const glm::vec3& l)
{
    glm::vec3 sum = material.ambient;
    const float cosine = glm::dot(normal, l);
    sum += material.diffuse * glm::max(0.0F, cosine);
    if (cosine > 0) {
        // The viewer mirrored, and compared with the light: the same angle.
        const glm::vec3 r = glm::reflect(-v, normal);
        sum += material.specular * glm::pow(glm::max(0.0F, glm::dot(r, l)), material.shininess);
    }
    return sum;
}

glm::vec3 light_towards(const World& world, const Hit& hit, const glm::vec3& v, int level)
{
    std::vector<Weighted> list;
    const glm::vec3 own = visit(world, hit, v, level, glm::vec3(1), list);
    return own + work_off(world, list);
}

glm::vec3 light_along(const World& world, const Ray& ray, int level)
{
    return work_off(world, {{ray, level, glm::vec3(1)}});
}

}
