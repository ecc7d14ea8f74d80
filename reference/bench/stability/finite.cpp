#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "inputs.hpp"
#include "measure.hpp"
#include "sweeps.hpp"

namespace stability {
namespace {

using List = std::vector<float>;

struct Precondition {
    const char* function;  ///< of a call
    bool (*holds)(const List& x);
};

bool null_at(const List& x, std::size_t at) { return v_at(x, at) == glm::vec3(0); }
bool unit_at(const List& x, std::size_t at)
{
    const glm::dvec3 v(v_at(x, at));
    return std::abs(glm::dot(v, v) - 1) < 1e-6;
}
// Thinner than the header of frames allows.
bool in_a_plane(const List& x, std::size_t at)
{
    const glm::dmat3 axes(m_at(x, at));
    return std::abs(glm::determinant(axes)) < 1e-6 * glm::length(axes[0]) * glm::length(axes[1]) * glm::length(axes[2]);
}
bool is_a_frame(const List& x, std::size_t at)
{
    return !null_at(x, at) && !null_at(x, at + 3) && !null_at(x, at + 6) && !in_a_plane(x, at);
}
bool light_outside(const List& x)
{
    const glm::dvec3 way = glm::dvec3(v_at(x, 4)) - glm::dvec3(v_at(x, 0));
    return x[3] > 0 && glm::length(way) > 1.001 * x[3];
}
// The slopes for which the header announces no NaN, and tangents that are not nearly parallel.
bool slopes_allowed(const List& x)
{
    const glm::dvec3 u(v_at(x, 3));
    const glm::dvec3 v(v_at(x, 6));
    return unit_at(x, 0) && std::abs(x[9]) <= 1e6 * glm::length(u) && std::abs(x[10]) <= 1e6 * glm::length(v) &&
           glm::length(glm::cross(u, v)) >= 1e-3 * glm::length(u) * glm::length(v);
}
bool exponent_allowed(const List& x) { return x[9] >= 0 && x[9] <= 1e4F; }

// What the headers ask of their arguments; where a function is not named, they ask nothing that could be broken, or
// throw.
std::vector<Precondition> preconditions()
{
    return {
        {"transforms::inverse_of_frame", [](const List& x) { return is_a_frame(x, 0); }},
        {"transforms::between_frames", [](const List& x) { return is_a_frame(x, 12); }},
        {"lighting::blinn_highlight", exponent_allowed},
        {"lighting::phong_highlight", exponent_allowed},
        {"lighting::brightest_diffuse", light_outside},
        {"raytracing::mirrored_direction", [](const List& x) { return unit_at(x, 0) && unit_at(x, 3); }},
        {"raytracing::critical_angle", [](const List& x) { return x[0] > 0 && x[1] > 0; }},
        {"texturing::box_place", [](const List& x) { return !null_at(x, 0); }},
        {"texturing::panorama_place", [](const List& x) { return !null_at(x, 0); }},
        {"texturing::sphere_place", [](const List& x) { return !null_at(x, 0); }},
        {"texturing::bumped_normal", slopes_allowed},
        {"texturing::level_at_distance", [](const List& x) { return x[0] > 0 && x[1] > 0; }},
    };
}

bool is_allowed(const std::vector<Precondition>& all, const char* function, const List& x)
{
    const auto found =
        std::ranges::find_if(all, [&](const Precondition& one) { return std::string(one.function) == function; });
    return found == all.end() || found->holds(x);
}

// Whether each infinity stands where the oracle, rounded, has the same.
bool overflows_alike(const Answer& given, const Answer& right)
{
    if (given.size() != right.size()) return false;
    for (std::size_t i = 0; i < given.size(); ++i)
        if (!std::isfinite(given[i]) && given[i] != right[i]) return false;
    return true;
}

}

FiniteResult finite_sweep(std::uint32_t count, std::uint64_t seed)
{
    const std::vector<Call> calls = reference_calls();
    const std::vector<Call> oracles = oracle_calls();
    const std::vector<Precondition> conditions = preconditions();
    FiniteResult result{calls.size(), 0, 0, 0, {}};
    umbral::Random random(seed);
    for (std::size_t at = 0; at < calls.size(); ++at) {
        bool found = false;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::vector<float> x = extreme_numbers(calls[at].shape, random);
            if (!is_allowed(conditions, calls[at].name, x)) continue;
            ++result.asked;
            try {
                const Answer given = calls[at].answer(x);
                if (is_finite(given)) continue;
                if (overflows_alike(given, oracles[at].answer(x))) {
                    ++result.overflowed;
                } else if (!found) {
                    found = true;
                    result.escapes.push_back({calls[at].name, code_of(calls[at], x)});
                }
            } catch (const std::invalid_argument&) {
                ++result.refused;
            }
        }
    }
    return result;
}

}
