#include <fmt/format.h>

#include <memory>
#include <umbral/raytracing/bounding_volumes.hpp>

#include "../ball_scene.hpp"
#include "../study.hpp"
#include "../timing.hpp"

namespace umbral::bench {
namespace {

std::optional<float> first_of_all(const std::vector<raytracing::Triangle>& triangles, Ray ray)
{
    std::optional<float> first;
    for (const raytracing::Triangle& triangle : triangles)
        if (const auto hit = raytracing::intersect(ray, triangle)) {
            first = hit->t;
            ray.t_max = hit->t;
        }
    return first;
}

}

Knob measure_hierarchy(Means& means)
{
    constexpr std::uint64_t seed = 23;
    Study study = study_of("hierarchy", "Every triangle or a tree",
                           fmt::format("Both find the same triangle to the bit. What a hierarchy costs is the time to "
                                       "make it, before the first ray; Umbral's references on balls of many triangles. "
                                       "Seed {}.",
                                       seed),
                           "ns per ray", {{"prepare", "time to prepare", "ns per triangle"}}, 1e9, "triangles");
    for (const std::uint32_t slices : {8U, 16U, 32U, 64U, 128U}) {
        Random random(seed);
        const auto triangles = std::make_shared<const std::vector<raytracing::Triangle>>(ball_triangles(slices));
        const std::vector<Ray> rays = rays_at_ball(slices < 64 ? 64 : 8, random);
        const auto count = static_cast<double>(triangles->size());
        const std::vector<std::function<void()>> making = {
            [&] { keep(raytracing::make_triangle_hierarchy(*triangles)); }};
        const double prepare = 1e9 * fastest_of_interleaved(making, {5, 2, 0.2, 0.001}).front() / count;
        const std::shared_ptr<const raytracing::TriangleHierarchy> hierarchy =
            raytracing::make_triangle_hierarchy(*triangles);
        const std::string situation = fmt::format("{}", triangles->size());
        study.knob.situations.push_back({situation, situation + " triangles", count});
        study.trials.push_back({"every triangle",
                                "every triangle",
                                count,
                                {{"prepare", 0}},
                                static_cast<double>(rays.size()),
                                [triangles, rays] {
                                    for (const Ray& ray : rays) keep(first_of_all(*triangles, ray));
                                },
                                situation});
        study.trials.push_back({"hierarchy",
                                "hierarchy",
                                count,
                                {{"prepare", prepare}},
                                static_cast<double>(rays.size()),
                                [hierarchy, rays] {
                                    for (const Ray& ray : rays) keep(hierarchy->first_hit(ray));
                                },
                                situation});
    }
    study.laws = {
        {"every triangle", "", "triangles", 1, "Each is asked.", "With few triangles a call's own cost shows."},
        {"hierarchy", "", "triangles", 0, "A path from the root to a leaf: a logarithm.",
         "A logarithm of few triangles, and more cache misses the larger the tree, look like a small power."}};
    return finish(std::move(study), means);
}

}
