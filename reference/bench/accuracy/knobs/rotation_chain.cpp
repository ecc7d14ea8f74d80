#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <umbral/core/random.hpp>

#include "../study.hpp"

namespace umbral::bench {
namespace {

glm::mat3 renormalised(const glm::mat3& m)
{
    const glm::vec3 x = normalize(m[0]);
    const glm::vec3 y = normalize(m[1] - dot(x, m[1]) * x);
    return {x, y, cross(x, y)};
}

/// How far a matrix is from a rotation: the largest entry of M^T M - 1.
double bent(const glm::dmat3& m)
{
    const glm::dmat3 rest = transpose(m) * m - glm::dmat3(1);
    double most = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(rest[i][k]));
    return most;
}

/// Steps of an animation: small turns about random axes.
std::vector<glm::quat> turns(int count, Random& random)
{
    std::vector<glm::quat> steps;
    for (int i = 0; i < count; ++i) {
        const float angle = random.uniform(0.01F, 0.2F);
        steps.push_back(glm::angleAxis(angle, random.unit_vector()));
    }
    return steps;
}

glm::dmat3 matrices(const std::vector<glm::quat>& steps)
{
    glm::mat3 total(1);
    for (const glm::quat& step : steps) total = glm::mat3_cast(step) * total;
    return glm::dmat3(total);
}

glm::dmat3 matrices_mended(const std::vector<glm::quat>& steps)
{
    glm::mat3 total(1);
    for (const glm::quat& step : steps) total = renormalised(glm::mat3_cast(step) * total);
    return glm::dmat3(total);
}

glm::dmat3 quaternions(const std::vector<glm::quat>& steps)
{
    glm::quat total(1, 0, 0, 0);
    for (const glm::quat& step : steps) total = step * total;
    return glm::dmat3(glm::mat3_cast(total));
}

glm::dmat3 quaternions_mended(const std::vector<glm::quat>& steps)
{
    glm::quat total(1, 0, 0, 0);
    for (const glm::quat& step : steps) total = normalize(step * total);
    return glm::dmat3(glm::mat3_cast(total));
}

glm::dmat3 in_double(const std::vector<glm::quat>& steps)
{
    glm::dmat3 total(1);
    for (const glm::quat& step : steps) total = glm::mat3_cast(normalize(glm::dquat(step))) * total;
    return total;
}

}

Knob measure_rotation_chain(Means& means)
{
    constexpr std::uint64_t seed = 27;
    const int chains = means.quick ? 12 : 100;
    Study study =
        study_of("rotation-chain", "Chains of rotations",
                 fmt::format("{} chains of small turns about random axes, multiplied up in float with and "
                             "without renormalisation, and in double: how far the product is from a rotation. "
                             "Seed {}.",
                             chains, seed),
                 "ns per step", {{"bent", "largest entry of MᵀM - 1, RMS", "per unit"}}, 1e9, "steps");
    const std::vector<std::pair<std::string, glm::dmat3 (*)(const std::vector<glm::quat>&)>> methods = {
        {"matrices", matrices},
        {"matrices, mended", matrices_mended},
        {"quaternions", quaternions},
        {"quaternions, mended", quaternions_mended},
        {"double", in_double}};
    for (const int count : {10, 100, 1000, 10'000}) {
        const std::string situation = fmt::format("{}", count);
        study.knob.situations.push_back({situation, situation + " steps", static_cast<double>(count)});
        for (const auto& [name, method] : methods) {
            Random random(seed);
            std::vector<double> errors;
            for (int chain = 0; chain < chains; ++chain) errors.push_back(bent(method(turns(count, random))));
            const std::vector<glm::quat> timed = turns(count, random);
            study.trials.push_back({name,
                                    name,
                                    static_cast<double>(count),
                                    {{"bent", root_mean_square(errors)}},
                                    static_cast<double>(count),
                                    [timed, method = method] { keep(method(timed)); },
                                    situation});
        }
    }
    const std::string walk = "Roundings of random steps add up like a random walk: √N.";
    const std::string drift = "A length that the steps' own roundings shrink or stretch always alike drifts as N.";
    study.laws = {{"matrices", "bent", "steps", 0.5, walk, drift},
                  {"quaternions", "bent", "steps", 0.5, walk, drift},
                  {"matrices, mended", "bent", "steps", 0, "Each step begins with a rotation again.", ""},
                  {"quaternions, mended", "bent", "steps", 0, "Each step begins with a rotation again.", ""}};
    return finish(std::move(study), means);
}

}
