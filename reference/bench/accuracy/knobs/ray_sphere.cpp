#include "../ray_sphere.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "../knee.hpp"
#include "../knob.hpp"
#include "../law.hpp"
#include "../textbook.hpp"
#include "../timing.hpp"

namespace umbral::bench {
namespace {

constexpr std::uint64_t seed = 1;
constexpr int timed_rays = 2048;

glm::dvec3 perpendicular_to(const glm::dvec3& axis, Random& random)
{
    const double angle = 6.283185307179586 * random.uniform_double();
    const glm::dvec3 side =
        normalize(std::abs(axis.x) < 0.7 ? cross(axis, glm::dvec3(1, 0, 0)) : cross(axis, glm::dvec3(0, 1, 0)));
    return std::cos(angle) * side + std::sin(angle) * cross(axis, side);
}

Situation from(int exponent)
{
    constexpr std::array powers = {"10", "100", "1000", "10⁴", "10⁵", "10⁶"};
    return {fmt::format("1e{}", exponent), fmt::format("from {} radii", powers[static_cast<std::size_t>(exponent - 1)]),
            std::pow(10.0, exponent)};
}

}

std::vector<Shot> shots_from(double distance, int count, Random& random)
{
    std::vector<Shot> shots;
    for (int i = 0; i < count; ++i) {
        const raytracing::Sphere sphere{random.in_cube(), random.uniform(0.5F, 2)};
        const glm::vec3 origin(glm::dvec3(sphere.centre) +
                               distance * double{sphere.radius} * glm::dvec3(random.unit_vector()));
        const glm::dvec3 to_centre = glm::dvec3(sphere.centre) - glm::dvec3(origin);
        const double offset = 1.3 * std::sqrt(random.uniform_double()) * double{sphere.radius};
        const glm::dvec3 aim = to_centre + offset * perpendicular_to(normalize(to_centre), random);
        shots.push_back({Ray{origin, glm::vec3(normalize(aim))}, sphere});
    }
    return shots;
}

ShotErrors errors_of(Intersect* variant, const std::vector<Shot>& shots)
{
    std::vector<double> errors;
    int wrong = 0;
    for (const auto& [ray, sphere] : shots) {
        const std::optional<float> got = variant(ray, sphere);
        const std::optional<Wide> exact = intersect_exactly(ray, sphere);
        if (got.has_value() != exact.has_value())
            ++wrong;
        else if (got)
            errors.push_back(error_in_ulp(*got, *exact));
    }
    ShotErrors found;
    if (!shots.empty()) found.wrong_hits = 100.0 * wrong / static_cast<double>(shots.size());
    if (errors.empty()) return found;
    std::sort(errors.begin(), errors.end());
    found.p95 = errors[static_cast<std::size_t>(0.95 * static_cast<double>(errors.size() - 1))];
    found.worst = errors.back();
    return found;
}

Knob measure_ray_sphere(Means& means)
{
    Knob knob{.id = "ray-sphere",
              .title = "Where a ray meets a sphere",
              .text = "",
              .time_unit = "ns per ray",
              .axis = "distance of the ray's origin, in radii",
              .measures = {{"p95_ulp", "error of t, 95th percentile", "ulp"},
                           {"worst_ulp", "error of t, worst", "ulp"},
                           {"wrong_hits", "wrong hits or misses", "%"}},
              .situations = {},
              .settings = {{"school, float", "the quadratic formula as printed in textbooks, all in float"},
                           {"reference", "Umbral's reference: float, but measures how far the ray passes the centre"},
                           {"school, double", "the quadratic formula in double, rounded to float at the end"},
                           {"oracle", "the quadratic formula in numbers of 113 bits"}},
              .results = {},
              .curves = {}};
    const std::array<Intersect*, 4> variants = {intersect_school, sphere_solution(means.units, "reference"),
                                                intersect_double, sphere_solution(means.units, "oracle")};
    const int samples = means.quick ? 4'000 : 200'000;
    knob.text = fmt::format(
        "{} thousand rays from each distance, aimed at a disc of 1.3 radii, so that some hit and some miss; seed {}. t "
        "is compared with a value of 113 bits "
        "that is not rounded: even the nearest float lies up to half an ulp from it. Every variant is called through a "
        "pointer, with the same rays.",
        samples / 1000, seed);
    for (int exponent = 1; exponent <= 6; ++exponent) {
        const Situation situation = from(exponent);
        knob.situations.push_back(situation);
        Random random(seed);
        const std::vector<Shot> shots = shots_from(situation.place, samples, random);
        const std::vector<Shot> timed(shots.begin(), shots.begin() + timed_rays);
        float sum = 0;
        std::vector<std::function<void()>> work;
        for (Intersect* const variant : variants)
            work.emplace_back([&sum, &timed, variant] {
                for (const auto& [ray, sphere] : timed) sum += variant(ray, sphere).value_or(0.0F);
            });
        const std::vector<double> seconds =
            fastest_of_interleaved(work, means.quick ? Patience{10, 5, 1} : Patience{200, 20, 4});
        for (std::size_t i = 0; i < variants.size(); ++i) {
            const ShotErrors errors = errors_of(variants[i], shots);
            knob.results.push_back(
                {knob.settings[i].first,
                 situation.id,
                 1e9 * seconds[i] / timed_rays,
                 {{"p95_ulp", errors.p95}, {"worst_ulp", errors.worst}, {"wrong_hits", errors.wrong_hits}},
                 knob.settings[i].first,
                 situation.place <= 1000 ? situation.place : 0});
        }
        knob.curves.push_back(curve_of(knob, situation.id, "p95_ulp"));
    }
    knob.laws = {
        law_of(knob, {"school, float", "p95_ulp", "radii", 1,
                      "Of the difference of two squares of the distance d, roundings of d² remain; the root "
                      "divides them by the radius, and an ulp of t is as large as d. Fitted up to 1000 radii: beyond "
                      "4096, where d² has no digit left for the radius, all errors are alike.",
                      "Rays that graze the ball lose more digits, and by the root of d only."}),
        law_of(knob, {"reference", "p95_ulp", "radii", 0,
                      "It measures how far the ray passes the centre, which does not grow with the distance.",
                      "Far away the origin's own roundings turn the ray."})};
    return knob;
}

}
