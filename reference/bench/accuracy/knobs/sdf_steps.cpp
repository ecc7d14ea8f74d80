#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <umbral/raytracing/sphere_tracing.hpp>

#include "../ray_sphere.hpp"
#include "../study.hpp"
#include "../textbook.hpp"

namespace umbral::bench {

Knob measure_sdf_steps(Means& means)
{
    constexpr std::uint64_t seed = 16;
    Random random(seed);
    std::vector<Shot> shots = shots_from(3, means.quick ? 20'000 : 200'000, random);
    std::erase_if(shots, [](const Shot& shot) { return !intersect_exactly(shot.ray, shot.sphere); });
    Study study = study_of("sdf-steps", "Step cap of sphere tracing",
                           fmt::format("{} rays that meet a ball, marched by Umbral's reference with a tolerance of "
                                       "1e-5 radii: the share that gives up before it arrives. Seed {}.",
                                       shots.size(), seed),
                           "ns per ray", {{"lost", "hits that are lost", "%"}});
    for (const int cap : {4, 8, 12, 16, 24, 32, 48, 64, 96}) {
        const auto trace = [cap](const Shot& shot) {
            const std::array<raytracing::sdf::DistanceFunction, 1> bodies = {[&shot](const glm::vec3& p) {
                return raytracing::sdf::ball_distance(p - shot.sphere.centre, shot.sphere.radius);
            }};
            return raytracing::sdf::sphere_trace(shot.ray, bodies, {1e-5F * shot.sphere.radius, cap});
        };
        const auto lost = std::count_if(shots.begin(), shots.end(), [&](const Shot& shot) { return !trace(shot); });
        const std::vector<Shot> timed(shots.begin(), shots.begin() + 2000);
        study.trials.push_back({fmt::format("{} steps", cap),
                                cap >= 12 ? "from 12 on" : "",
                                static_cast<double>(cap),
                                {{"lost", 100.0 * static_cast<double>(lost) / static_cast<double>(shots.size())}},
                                2000,
                                [timed, trace] {
                                    for (const Shot& shot : timed) keep(trace(shot));
                                }});
    }
    study.laws = {{"from 12 on", "lost", "steps", -2,
                   "A ray at the angle a to the surface needs some 1/a steps, and in a ring of the width a² at the "
                   "silhouette the angles are below a.",
                   "The logarithm of the tolerance, by which rays of moderate angles need more steps, is still felt."}};
    return finish(std::move(study), means);
}

}
