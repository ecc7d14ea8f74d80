#include <fmt/format.h>

#include <array>
#include <cmath>
#include <umbral/raytracing/sphere_tracing.hpp>

#include "../ray_sphere.hpp"
#include "../study.hpp"
#include "../textbook.hpp"

namespace umbral::bench {

Knob measure_sdf_tolerance(Means& means)
{
    constexpr std::uint64_t seed = 15;
    Random random(seed);
    const std::vector<Shot> shots = shots_from(3, means.quick ? 2000 : 20'000, random);
    Study study = study_of("sdf-tolerance", "Tolerance of sphere tracing",
                           fmt::format("Umbral's reference marches {} rays from three radii towards balls, as many "
                                       "steps as it takes, and stops within the tolerance of the surface. t against a "
                                       "value of 113 bits; seed {}.",
                                       shots.size(), seed),
                           "ns per ray", {{"median", "error of t, median", "of the distance"}});
    for (const float tolerance : {1e-1F, 3e-2F, 1e-2F, 3e-3F, 1e-3F, 3e-4F, 1e-4F, 1e-5F}) {
        const auto trace = [tolerance](const Shot& shot) {
            const std::array<raytracing::sdf::DistanceFunction, 1> bodies = {[&shot](const glm::vec3& p) {
                return raytracing::sdf::ball_distance(p - shot.sphere.centre, shot.sphere.radius);
            }};
            return raytracing::sdf::sphere_trace(shot.ray, bodies, {tolerance * shot.sphere.radius, 2000});
        };
        std::vector<double> errors;
        for (const Shot& shot : shots) {
            const std::optional<Wide> exact = intersect_exactly(shot.ray, shot.sphere);
            const auto got = trace(shot);
            if (exact && got) errors.push_back(std::abs(got->t / static_cast<double>(*exact) - 1));
        }
        std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
        const std::vector<Shot> timed(shots.begin(), shots.begin() + 500);
        study.trials.push_back({fmt::format("{:g}", tolerance),
                                "",
                                double{tolerance},
                                {{"median", errors[errors.size() / 2]}},
                                500,
                                [timed, trace] {
                                    for (const Shot& shot : timed) keep(trace(shot));
                                }});
    }
    study.laws = {{"", "median", "tolerance", 1,
                   "The march ends at a distance in proportion to the tolerance, and so does what is left of the ray.",
                   "The last step goes below the tolerance by a factor of its own."}};
    return finish(std::move(study), means);
}

}
