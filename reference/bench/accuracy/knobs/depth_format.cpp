#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <umbral/core/random.hpp>

#include "../study.hpp"

namespace umbral::bench {
namespace {

constexpr double far_plane = 1000;

/// Depth in [0, 1] of a distance, 0 at the near plane; `reversed`: 1 there.
double depth_of(double z, double near, bool reversed)
{
    const double depth = far_plane * (z - near) / (z * (far_plane - near));
    return reversed ? near * (far_plane - z) / (z * (far_plane - near)) : depth;
}

double distance_of(double depth, double near, bool reversed)
{
    if (reversed) return far_plane * near / (near + depth * (far_plane - near));
    return far_plane * near / (far_plane - depth * (far_plane - near));
}

/// What is kept of a depth: whole numbers of so many bits, or a float, or a double.
template <class Stored>
Stored stored(double depth, double levels)
{
    if constexpr (std::is_integral_v<Stored>) return static_cast<Stored>(std::lround(depth * levels));
    return static_cast<Stored>(depth);
}

/// The depth test of a frame of fragments.
template <class Stored>
void test_depths(const std::vector<Stored>& fragments, std::vector<Stored>& buffer)
{
    for (std::size_t i = 0; i < fragments.size(); ++i) buffer[i] = std::min(fragments[i], buffer[i]);
    keep(buffer);
}

template <class Stored>
Trial trial_of(const std::string& name, double levels, bool reversed, double near, const std::vector<double>& places)
{
    std::vector<double> errors;
    std::vector<Stored> fragments;
    for (const double z : places) {
        const Stored kept = stored<Stored>(depth_of(z, near, reversed), levels);
        fragments.push_back(kept);
        const double back = distance_of(static_cast<double>(kept) / levels, near, reversed);
        errors.push_back(std::isfinite(back) && back > 0 ? std::min(1.0, std::abs(back / z - 1)) : 1.0);
    }
    std::sort(errors.begin(), errors.end());
    // More than the caches near the processor hold, as a frame's buffer is: what counts are the bytes.
    while (fragments.size() < 400'000) fragments.insert(fragments.end(), fragments.begin(), fragments.begin() + 10'000);
    std::vector<Stored> buffer(fragments.rbegin(), fragments.rend());
    return {name,
            name,
            near,
            {{"p95", errors[errors.size() * 95 / 100]}},
            static_cast<double>(fragments.size()),
            [fragments, buffer]() mutable { test_depths(fragments, buffer); },
            fmt::format("{:g}", near)};
}

}

Knob measure_depth_format(Means& means)
{
    constexpr std::uint64_t seed = 19;
    Random random(seed);
    std::vector<double> places;
    for (int i = 0; i < (means.quick ? 20'000 : 200'000); ++i)
        places.push_back(10 * std::pow(90.0, random.uniform_double()));
    Study study = study_of("depth-format", "Depth formats, near plane",
                           fmt::format("How well a stored depth tells a distance: {} distances from 10 to 900, the far "
                                       "plane at 1000; seed {}. “Reversed” has 1 at the near plane. The time is a "
                                       "depth test's.",
                                       places.size(), seed),
                           "ns per test", {{"p95", "error of the distance, 95th percentile", "of it"}}, 1e9,
                           "distance of the near plane");
    for (const double near : {0.01, 0.1, 1.0}) {
        study.knob.situations.push_back({fmt::format("{:g}", near), fmt::format("near plane at {:g}", near), near});
        study.trials.push_back(trial_of<std::uint16_t>("16 bits", 65535, false, near, places));
        study.trials.push_back(trial_of<std::uint32_t>("24 bits", 16777215, false, near, places));
        study.trials.push_back(trial_of<float>("float", 1, false, near, places));
        study.trials.push_back(trial_of<float>("float, reversed", 1, true, near, places));
        study.trials.push_back(trial_of<double>("double", 1, false, near, places));
    }
    const std::string reason = "At a distance z one level of depth is z²/near wide: ten times nearer, ten times worse.";
    study.laws = {{"24 bits", "p95", "near plane", -1, reason, "An error of all the distance cannot grow."},
                  {"float", "p95", "near plane", -1, reason, "An error of all the distance cannot grow."},
                  {"float, reversed", "p95", "near plane", 0,
                   "Floats lie the denser the nearer 0, in proportion to near/z: the near plane cancels.", ""}};
    return finish(std::move(study), means);
}

}
