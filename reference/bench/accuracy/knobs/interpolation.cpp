#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "../study.hpp"

namespace umbral::bench {
namespace {

glm::quat nlerp(const glm::quat& a, const glm::quat& b, float t) { return normalize(a * (1 - t) + b * t); }

/// nlerp with a time that is bent by a polynomial. Based on: A. Kapoulkine. Approximating slerp. 2015.
glm::quat corrected(const glm::quat& a, const glm::quat& b, float t)
{
    const float d = dot(a, b);
    const float k = 0.931872F + d * (-1.25654F + d * 0.331442F);
    const float bent = t + t * (t - 0.5F) * (t - 1) * k;
    return nlerp(a, b, bent);
}

/// The middle is exact; each half is an nlerp of half the angle.
glm::quat halved(const glm::quat& a, const glm::quat& b, float t)
{
    const glm::quat middle = normalize(a + b);
    return t < 0.5F ? nlerp(a, middle, 2 * t) : nlerp(middle, b, 2 * t - 1);
}

glm::quat spherical(const glm::quat& a, const glm::quat& b, float t) { return glm::slerp(a, b, t); }

}

Knob measure_interpolation(Means& means)
{
    constexpr double degrees = 57.29577951308232;
    Study study = study_of("interpolation", "Rotations: nlerp and slerp",
                           "The angle reached between two rotations, beside the one that should be: the largest "
                           "deviation over 1001 moments. “Bent” corrects nlerp's time by a polynomial; “halved” takes "
                           "the exact middle first.",
                           "ns per rotation", {{"worst", "worst deviation of the angle", "degrees"}}, 1e9,
                           "angle between the rotations, degrees");
    const std::vector<std::pair<std::string, glm::quat (*)(const glm::quat&, const glm::quat&, float)>> methods = {
        {"nlerp", nlerp}, {"bent nlerp", corrected}, {"halved nlerp", halved}, {"slerp", spherical}};
    for (const int angle : {15, 30, 60, 120}) {
        const std::string situation = fmt::format("{}", angle);
        study.knob.situations.push_back({situation, fmt::format("{} degrees", angle), static_cast<double>(angle)});
        const glm::quat a(1, 0, 0, 0);
        const glm::vec3 axis = normalize(glm::vec3(1, 2, 3));
        const glm::quat b = glm::angleAxis(static_cast<float>(angle / degrees), axis);
        for (const auto& [name, method] : methods) {
            double worst = 0;
            for (int i = 0; i <= 1000; ++i) {
                const glm::dquat got(method(a, b, static_cast<float>(i) / 1000));
                const double along = dot(glm::dvec3(got.x, got.y, got.z), glm::dvec3(axis));
                worst = std::max(worst, std::abs(2 * degrees * std::atan2(along, got.w) - angle * i / 1000.0));
            }
            study.trials.push_back({name,
                                    name,
                                    static_cast<double>(angle),
                                    {{"worst", worst}},
                                    1000,
                                    [a, b, method = method] {
                                        for (int i = 0; i < 1000; ++i) keep(method(a, b, static_cast<float>(i) / 1000));
                                    },
                                    situation});
        }
    }
    const std::string cubic = "An arc's and its chord's parts differ by the cube of the angle.";
    study.laws = {
        {"nlerp", "worst", "degrees", 3, cubic, "At large angles the next term, of the fifth power, adds to it."},
        {"halved nlerp", "worst", "degrees", 3, cubic, "At small angles float's roundings are as large."}};
    return finish(std::move(study), means);
}

}
