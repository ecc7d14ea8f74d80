#include "render/rays/light.hpp"

#include <algorithm>
#include <cmath>
#include <umbral/raytracing/reflect_refract.hpp>

#include "render/rays/bump.hpp"

namespace umbral::render::rays {
namespace {

/// What is left to be spent on a path.
struct Budget {
    int depth;         ///< of mirrors and glass
    int bounces;       ///< between other surfaces
    float weight = 1;  ///< what the light that is looked for counts in the picture, at most

    /// After a share of the light went another way. Rays that count for less than half a level of 255 end.
    [[nodiscard]] Budget through_glass(const glm::vec3& share) const
    {
        return {depth - 1, bounces, weight * std::max({share.r, share.g, share.b})};
    }
    [[nodiscard]] bool counts() const { return weight > 1.0F / 512; }
};

class Follower {
public:
    Follower(const World& world, const Reach& reach, Samples& samples, RayCounts& counts)
        : world_(world), list_(*world.list), reach_(reach), samples_(samples), counts_(counts)
    {
    }

    Arrived follow(const Ray& ray, const Budget& budget)
    {
        std::optional<Seen> seen = look(world_, ray);
        if (!seen) return {};
        if (reach_.bumps && seen->draw->bump) {
            ++counts_.bumped;
            seen->normal = bumped(world_, *seen, ray.direction);
        }
        glm::vec3 light = local(*seen, ray);
        if (budget.bounces > 0) light += from_surfaces(*seen, budget);
        if (budget.depth > 0) light += mirrored_and_refracted(*seen, ray, budget);
        return {light, seen->draw, seen->position};
    }

private:
    /// Of what comes from where there is nothing, the sky's part.
    glm::vec3 light_along(const Ray& ray, const Budget& budget)
    {
        const Arrived arrived = follow(ray, budget);
        if (arrived.draw != nullptr) return arrived.light;
        const float height = dot(normalize(ray.direction), list_.up);
        return glm::mix(list_.background_bottom, list_.background_top, 0.5F + 0.5F * height);
    }

    glm::vec3 local(const Seen& seen, const Ray& ray)
    {
        const SurfacePoint at{seen.position, seen.normal, seen.uv};
        Counters work;
        const bool is_lit_by_surfaces = reach_.bounces > 0;
        const auto sees = [&](const Light& light) { return !reach_.shadows || reaches(seen, light); };
        return shade_from<all_effects>(list_, *seen.draw, at, -normalize(ray.direction), !is_lit_by_surfaces, work,
                                       sees);
    }

    /// A point of the light is chosen by chance; of a light without size there is one only.
    bool reaches(const Seen& seen, const Light& light)
    {
        glm::vec3 to_light(light.where);
        const bool has_place = light.where.w != 0;
        if (has_place) to_light -= seen.smoothed;
        if (light.size > 0) {
            ++counts_.soft;
            const glm::vec3 axis = normalize(to_light);
            const auto [x, y] = across(axis);
            const glm::vec2 disc = light.size * on_disc(samples_.next());
            to_light += disc.x * x + disc.y * y;
        }
        if (dot(seen.face, to_light) <= 0) return false;
        ++counts_.shadow;
        Ray ray = ray_from(seen, seen.smoothed, to_light);
        if (has_place) ray.t_max = 1;
        return !raytrace::is_blocked(world_.hierarchy, ray);
    }

    /// Light that other surfaces send: one direction by the cosine, whose density cancels cosine and 1/pi.
    glm::vec3 from_surfaces(const Seen& seen, const Budget& budget)
    {
        const glm::vec3 albedo = textured(list_, *seen.draw, seen.uv, seen.draw->material.diffuse);
        if (albedo == glm::vec3(0)) return albedo;
        const glm::vec2 disc = on_disc(samples_.next());
        const float height = std::sqrt(std::max(0.0F, 1 - dot(disc, disc)));
        const auto [x, y] = across(seen.normal);
        glm::vec3 direction = disc.x * x + disc.y * y + height * seen.normal;
        // Round an interpolated normal some lead into the triangle: light from there comes from beside it instead.
        if (const float below = dot(direction, seen.face); below < 0) direction -= 2 * below * seen.face;
        ++counts_.bounced;
        return albedo *
               light_along(ray_from(seen, seen.position, direction), {budget.depth, budget.bounces - 1, budget.weight});
    }

    glm::vec3 mirrored_and_refracted(const Seen& seen, const Ray& ray, const Budget& budget)
    {
        const scene::Material& material = seen.draw->material;
        const bool is_glass = material.transmit != glm::vec3(0);
        if (!is_glass && material.mirror == glm::vec3(0)) return glm::vec3(0);
        const glm::vec3 v = -normalize(ray.direction);
        // Interpolated normals may turn away from who looks.
        const glm::vec3 n = dot(v, seen.normal) > 0 ? seen.normal : seen.face;
        float reflectance = 0;
        glm::vec3 light(0);
        if (is_glass) {
            const float before = seen.from_behind ? material.index : 1;
            const float behind = seen.from_behind ? 1 : material.index;
            const auto refracted = raytracing::refracted_direction(v, n, before, behind);
            reflectance = refracted ? fresnel(dot(v, n), -dot(*refracted, n), before, behind) : 1;
            if (refracted && dot(*refracted, seen.face) < 0)
                light += shared(seen, *refracted, (1 - reflectance) * material.transmit, budget, counts_.refracted);
        }
        const glm::vec3 share = material.mirror + reflectance * material.transmit;
        const glm::vec3 mirrored = raytracing::mirrored_direction(v, n);
        if (dot(mirrored, seen.face) > 0) light += shared(seen, mirrored, share, budget, counts_.mirrored);
        return light;
    }

    /// A share of the light that comes from there.
    glm::vec3 shared(const Seen& seen, const glm::vec3& direction, const glm::vec3& share, const Budget& budget,
                     std::uint64_t& count)
    {
        const Budget rest = budget.through_glass(share);
        if (!rest.counts()) return glm::vec3(0);
        ++count;
        return share * light_along(ray_from(seen, seen.position, direction), rest);
    }

    /// The share of light that is reflected where it meets another index, by the cosines before and behind.
    static float fresnel(float cosine_before, float cosine_behind, float before, float behind)
    {
        const float s =
            (before * cosine_before - behind * cosine_behind) / (before * cosine_before + behind * cosine_behind);
        const float p =
            (behind * cosine_before - before * cosine_behind) / (behind * cosine_before + before * cosine_behind);
        return (s * s + p * p) / 2;
    }

    const World& world_;
    const DrawList& list_;
    Reach reach_;
    Samples& samples_;
    RayCounts& counts_;
};

}

Arrived follow(const World& world, const Reach& reach, const Ray& ray, Samples& samples, RayCounts& counts)
{
    return Follower(world, reach, samples, counts).follow(ray, {reach.depth, reach.bounces});
}

}
