#include <fmt/format.h>

#include <cmath>
#include <umbral/raytracing/whitted.hpp>

#include "../study.hpp"

namespace umbral::bench {
namespace {

/// Between two facing mirrors that glow: each level adds the reflectivity's next power.
class Mirrors final : public raytracing::whitted::World {
public:
    Mirrors(float reflectivity, int levels) : reflectivity_(reflectivity), levels_(levels) {}

    [[nodiscard]] std::optional<raytracing::whitted::Hit> first_hit(const Ray& ray) const override
    {
        if (ray.direction.z == 0) return std::nullopt;
        const float wall = ray.direction.z > 0 ? 1.0F : -1.0F;
        const float t = (wall - ray.origin.z) / ray.direction.z;
        if (t <= ray.t_min || t >= ray.t_max) return std::nullopt;
        raytracing::whitted::Hit hit{};
        hit.t = t;
        hit.position = ray.origin + t * ray.direction;
        hit.normal = {0, 0, -wall};
        hit.material.mirrored = reflectivity_;
        return hit;
    }
    [[nodiscard]] glm::vec3 background(const glm::vec3&) const override { return glm::vec3(0); }
    [[nodiscard]] glm::vec3 texture_color(std::uint32_t, const glm::vec2&) const override { return glm::vec3(1); }
    [[nodiscard]] std::span<const lighting::Light> lights() const override { return {}; }
    [[nodiscard]] glm::vec3 ambient() const override { return glm::vec3(0.25F); }
    [[nodiscard]] int max_level() const override { return levels_; }

private:
    float reflectivity_;
    int levels_;
};

}

Knob measure_mirror_depth(Means& means)
{
    Study study = study_of("mirror-depth", "Depth of reflections",
                           "Whitted's ray tracing (Umbral's reference) between two facing, glowing mirrors, cut "
                           "off at a level, against the sum of the endless series.",
                           "ns per ray", {{"missing", "light that is missing", "of all"}});
    const Ray ray{{0, 0, 0}, normalize(glm::vec3(0.1F, 0.2F, 1))};
    for (const int percent : {80, 50}) {
        const std::string family = fmt::format("{} %", percent);
        const double k = percent / 100.0;
        for (const int levels : {1, 2, 3, 4, 6, 8, 12}) {
            const Mirrors world(static_cast<float>(k), levels);
            const double got = raytracing::whitted::light_along(world, ray, 1).x;
            study.trials.push_back({fmt::format("{} %, {} levels", percent, levels),
                                    family,
                                    static_cast<double>(levels),
                                    {{"missing", std::abs(1 - got * (1 - k) / 0.25)}},
                                    512,
                                    [world, ray] {
                                        for (int i = 0; i < 512; ++i)
                                            keep(raytracing::whitted::light_along(world, ray, 1));
                                    }});
        }
        study.laws.push_back({family, "missing", "levels", std::log10(k),
                              "What is left out is a geometric series, k to the power of the levels.",
                              "Sums in float do not hold small rests.", true});
    }
    return finish(std::move(study), means);
}

}
