// alternative: computes in double, with angles where others have roots, and moves the origins of rays off the surface
#include <cmath>
#include <umbral/raytracing/whitted.hpp>

namespace umbral::raytracing::whitted {
namespace {

using V = glm::dvec3;

V direct(const lighting::Material& m, V n, V v, V l)
{
    const double c = glm::dot(n, l);
    V light(m.ambient);
    if (c > 0) {
        light += c * V(m.diffuse);
        const double h = glm::dot(2 * c * n - l, v);
        if (h > 0) light += std::pow(h, double(m.shininess)) * V(m.specular);
    }
    return light;
}

class Shader {
public:
    Shader(const World& world, const Hit& hit, V v, int level)
        : world_(world), hit_(hit), v_(v), level_(level), entering_(glm::dot(V(hit.normal), v) >= 0)
    {
        n_ = entering_ ? V(hit.normal) : -V(hit.normal);
    }

    V all() const
    {
        V sum = own();
        if (level_ < world_.max_level()) sum += mirrored() + refracted();
        return sum;
    }

private:
    V own() const
    {
        lighting::Material m = hit_.material.local;
        if (const auto texture = hit_.material.texture) {
            const glm::vec3 c = world_.texture_color(texture, hit_.uv);
            m.ambient *= c;
            m.diffuse *= c;
        }
        V sum = V(m.emission) + V(world_.ambient());
        for (const auto& light : world_.lights()) {
            const V to = V(light.position) - double(light.position.w) * V(hit_.position);
            Ray ray;
            ray.origin = hit_.position;
            // Lengths of the whole way: a place is at t = 1.
            ray.direction = glm::vec3(to);
            ray.t_min = static_cast<float>(double(clearance) / glm::length(to));
            if (light.position.w != 0) ray.t_max = 1;
            if (world_.first_hit(ray).has_value()) continue;
            sum += V(light.color) * direct(m, n_, v_, glm::normalize(to));
        }
        return sum;
    }
    V follow(V direction, double k, const glm::vec3& color) const
    {
        // Off the surface by the clearance, on the side to which the ray goes.
        const V off = (glm::dot(direction, n_) > 0 ? 1.0 : -1.0) * double(clearance) * n_;
        const Ray ray{glm::vec3(V(hit_.position) + off), glm::vec3(direction)};
        return k * V(color) * V(light_along(world_, ray, level_ + 1));
    }
    V mirrored() const
    {
        const auto& m = hit_.material;
        if (!(m.mirrored > 0)) return V(0);
        return follow(2 * glm::dot(n_, v_) * n_ - v_, m.mirrored, m.mirrored_color);
    }
    V refracted() const
    {
        const auto& m = hit_.material;
        if (!(m.refracted > 0)) return V(0);
        // Snell, with sines: the part of -v along the surface is scaled, and the rest points to the other side.
        const V along = glm::dot(n_, v_) * n_ - v_;
        const V behind = along * (entering_ ? 1.0 / m.index : double(m.index));
        const double sine = glm::length(behind);
        if (sine > 1) return V(0);
        return follow(behind - std::cos(std::asin(sine)) * n_, m.refracted, m.refracted_color);
    }

    const World& world_;
    const Hit& hit_;
    V v_;
    V n_;
    int level_;
    bool entering_;
};

}

glm::vec3 direct_light(const lighting::Material& material, const glm::vec3& normal, const glm::vec3& v,
                       const glm::vec3& l)
{
    return glm::vec3(direct(material, V(normal), V(v), V(l)));
}

glm::vec3 light_towards(const World& world, const Hit& hit, const glm::vec3& v, int level)
{
    return glm::vec3(Shader(world, hit, V(v), level).all());
}

glm::vec3 light_along(const World& world, const Ray& ray, int level)
{
    if (level > world.max_level()) return {0, 0, 0};
    if (const auto hit = world.first_hit(ray)) return light_towards(world, *hit, -ray.direction, level);
    return world.background(ray.direction);
}

}
