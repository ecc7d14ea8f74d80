#include <fmt/format.h>

#include <cmath>
#include <umbral/core/random.hpp>

#include "../study.hpp"

namespace umbral::bench {
namespace {

/// A bump map's height, in float.
float height(float x, float y) { return 0.1F * std::sin(5 * x) * std::cos(4 * y); }

glm::dvec3 exact_normal(const glm::vec2& p)
{
    const double dx = 0.5 * std::cos(5.0 * p.x) * std::cos(4.0 * p.y);
    const double dy = -0.4 * std::sin(5.0 * p.x) * std::sin(4.0 * p.y);
    return normalize(glm::dvec3(-dx, -dy, 1));
}

glm::vec3 forward(const glm::vec2& p, float h)
{
    const float here = height(p.x, p.y);
    return normalize(glm::vec3(here - height(p.x + h, p.y), here - height(p.x, p.y + h), h));
}

glm::vec3 central(const glm::vec2& p, float h)
{
    return normalize(
        glm::vec3(height(p.x - h, p.y) - height(p.x + h, p.y), height(p.x, p.y - h) - height(p.x, p.y + h), 2 * h));
}

}

Knob measure_normal_difference(Means& means)
{
    constexpr std::uint64_t seed = 31;
    Random random(seed);
    std::vector<glm::vec2> places;
    for (int i = 0; i < (means.quick ? 3000 : 50'000); ++i) {
        const float x = random.uniform();
        places.emplace_back(x, random.uniform());
    }
    Study study = study_of("normal-difference", "Normals by differences",
                           fmt::format("The normal of a bumpy surface from heights in float, a step apart: {} places "
                                       "against the derivative; seed {}. Small steps lose digits, wide ones miss the "
                                       "curvature. Slopes are fitted to steps of at least four times the best one.",
                                       places.size(), seed),
                           "ns per normal", {{"rms", "angle of the normal, RMS", "degrees"}});
    using Method = glm::vec3 (*)(const glm::vec2&, float);
    // The best steps are about the root and the cubic root of float's half ulp.
    for (const auto& [family, method, best] :
         {std::tuple{"forward", Method{forward}, 2.4e-4}, std::tuple{"central", Method{central}, 4e-3}})
        for (const float h : {0.1F, 0.05F, 0.02F, 0.01F, 3e-3F, 1e-3F, 3e-4F, 1e-4F, 1e-5F}) {
            std::vector<double> errors;
            for (const glm::vec2& place : places)
                errors.push_back(57.29577951308232 *
                                 std::asin(length(cross(exact_normal(place), glm::dvec3(method(place, h))))));
            const std::vector<glm::vec2> timed(places.begin(), places.begin() + 500);
            study.trials.push_back({fmt::format("{} {:g}", family, h),
                                    family,
                                    double{h} >= 4 * best ? double{h} : 0,
                                    {{"rms", root_mean_square(errors)}},
                                    500,
                                    [timed, h, method = method] {
                                        for (const glm::vec2& place : timed) keep(method(place, h));
                                    }});
        }
    study.laws = {
        {"forward", "rms", "step", 1, "What is left out is half a second derivative times the step.", ""},
        {"central", "rms", "step", 2, "The second derivative cancels; the third one, times h², is left.", ""}};
    return finish(std::move(study), means);
}

}
