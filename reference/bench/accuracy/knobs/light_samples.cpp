#include <fmt/format.h>

#include <cmath>

#include "../sampled_study.hpp"

namespace umbral::bench {
namespace {

/// The lamp: the square from -1 to 1 in the plane z = 1, of radiance 1, above ground points (x, y, 0) that face up.
constexpr double height = 1;

/// Irradiance by Lambert's formula for a polygon: half the sum of each edge's angle times the cosine of its plane.
double exact_irradiance(const glm::dvec2& at)
{
    const glm::dvec3 corners[] = {{-1, -1, height}, {-1, 1, height}, {1, 1, height}, {1, -1, height}};
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        const glm::dvec3 a = normalize(corners[i] - glm::dvec3(at, 0));
        const glm::dvec3 b = normalize(corners[(i + 1) % 4] - glm::dvec3(at, 0));
        sum += std::acos(dot(a, b)) * normalize(cross(a, b)).z;
    }
    return std::abs(sum) / 2;
}

double estimate(const glm::dvec2& at, const std::vector<glm::dvec2>& samples)
{
    double sum = 0;
    for (const glm::dvec2& sample : samples) {
        const glm::dvec2 flat = 2.0 * sample - 1.0 - at;
        const double squared = dot(flat, flat) + height * height;
        sum += height * height / (squared * squared);
    }
    return 4 * sum / static_cast<double>(samples.size());
}

}

Knob measure_light_samples(Means& means)
{
    constexpr std::uint64_t seed = 13;
    const int places = means.quick ? 300 : 3000;
    Study study = study_of("light-samples", "Samples of a square lamp",
                           fmt::format("Light that {} random points of the ground get from an unhidden square "
                                       "lamp twice as wide as it hangs high, against Lambert's closed formula; "
                                       "seed {}.",
                                       places, seed),
                           "ns per point", {{"rms", "relative error of the light, RMS", "of it"}});
    const SamplePattern grid = {"grid", [](int count, Random&) { return cells(count, nullptr); }};
    add_sampled_trials(study, {independent_pattern(), stratified_pattern(), grid}, seed, places,
                       {[](Random& random, const auto& points) {
                            const double x = 3 * random.uniform_double();
                            const glm::dvec2 at(x, 3 * random.uniform_double());
                            return estimate(at, points()) / exact_irradiance(at) - 1;
                        },
                        [](int i, Random&, const auto& points) {
                            return estimate({0.1 * i, 0.3}, points());
                        }});
    study.laws = {{"random", "rms", "samples", -0.5, "The variance of a mean of independent samples is 1/N.", ""},
                  {"stratified", "rms", "samples", -1,
                   "Within a cell of width 1/√N smooth light varies by 1/√N: the variance is 1/N · 1/N.",
                   "With one or four cells the light is not yet straight within a cell."},
                  {"grid", "rms", "samples", -1, "The midpoint rule errs by the square of the cells' width: 1/N.",
                   "With one or four cells the light is not yet a parabola within a cell."}};
    return finish(std::move(study), means);
}

}
