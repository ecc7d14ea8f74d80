#pragma once

#include <cmath>
#include <kit/varied.hpp>
#include <limits>
#include <numbers>
#include <umbral/core/random.hpp>
#include <umbral/interaction/three_mode_camera.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <utility>
#include <vector>

/// What a user does to a three-mode camera, one step after the other.
namespace umbral::interaction {

struct ThreeModeStep {
    enum class Kind { move_xy, move_z, look_toward, next_mode };
    Kind kind = Kind::next_mode;
    glm::dvec3 a{0};  ///< right and up; backwards; or the point
};

inline ThreeModeStep move_xy(double right, double up) { return {ThreeModeStep::Kind::move_xy, {right, up, 0}}; }
inline ThreeModeStep move_z(double steps) { return {ThreeModeStep::Kind::move_z, {steps, 0, 0}}; }
inline ThreeModeStep look_toward(const glm::dvec3& point) { return {ThreeModeStep::Kind::look_toward, point}; }
inline ThreeModeStep next_mode() { return {}; }

inline void apply(ThreeModeCamera& camera, const ThreeModeStep& step)
{
    switch (step.kind) {
        case ThreeModeStep::Kind::move_xy: return camera.move_xy(step.a.x, step.a.y);
        case ThreeModeStep::Kind::move_z: return camera.move_z(step.a.x);
        case ThreeModeStep::Kind::look_toward: return camera.look_toward(step.a);
        case ThreeModeStep::Kind::next_mode: return camera.next_mode();
    }
}

/// The same as questions (ask.hpp).
inline void apply(Recorder& out, ThreeModeCamera& camera, const ThreeModeStep& step)
{
    const glm::dvec3& a = step.a;
    switch (step.kind) {
        case ThreeModeStep::Kind::move_xy: return ask<&ThreeModeCamera::move_xy>(out, camera, a.x, a.y);
        case ThreeModeStep::Kind::move_z: return ask<&ThreeModeCamera::move_z>(out, camera, a.x);
        case ThreeModeStep::Kind::look_toward: return ask<&ThreeModeCamera::look_toward>(out, camera, a);
        case ThreeModeStep::Kind::next_mode: return ask<&ThreeModeCamera::next_mode>(out, camera);
    }
}

/// In [-reach, reach).
inline double random_length(Random& random, double reach) { return reach * (2 * random.uniform_double() - 1); }

inline glm::dvec3 random_point(Random& random, double reach)
{
    const double x = random_length(random, reach);
    const double y = random_length(random, reach);
    return {x, y, random_length(random, reach)};
}

/// A camera within `reach` of the origin in each direction, 2 to 6 away from what it looks at; of six one stands at a
/// pole.
inline ThreeModeSettings random_three_mode(Random& random, double reach = 3)
{
    ThreeModeSettings settings;
    settings.attention = random_point(random, reach);
    settings.azimuth = random_length(random, 3);
    settings.elevation = random_length(random, 1.2);
    if (random.below(6) == 0) settings.elevation = std::copysign(std::numbers::pi / 2, settings.elevation);
    settings.distance = 2 + 4 * random.uniform_double();
    settings.min_distance = 0.25 + 0.75 * random.uniform_double();
    settings.max_distance = 12 + 8 * random.uniform_double();
    settings.zoom_step = 0.05 + 0.2 * random.uniform_double();
    return settings;
}

/// Another camera to begin with, if inputs are to vary: its limits are the same, at a pole it remains there.
inline ThreeModeSettings varied(Variation& vary, ThreeModeSettings settings)
{
    settings.attention = vary.near(settings.attention, 0.5);
    settings.azimuth = vary.near(settings.azimuth, 0.4);
    if (std::abs(settings.elevation) < std::numbers::pi / 2) settings.elevation = vary.near(settings.elevation, 0.1);
    settings.distance = vary.scaled(settings.distance, 1.2F);
    return settings;
}

/// Where the observer stands at the beginning.
inline glm::dvec3 observer_of(const ThreeModeSettings& s)
{
    return s.attention + s.distance * glm::dvec3(std::cos(s.elevation) * std::sin(s.azimuth), std::sin(s.elevation),
                                                 std::cos(s.elevation) * std::cos(s.azimuth));
}

/// Steps in all modes, within about 10 of `middle`: mostly turns and moves, then steps backwards and forwards, other
/// modes, points to look at, some of them too far, and nonsense.
inline std::vector<ThreeModeStep> random_steps(Random& random, int count, const glm::dvec3& middle = glm::dvec3(0))
{
    constexpr double nonsense[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
    std::vector<ThreeModeStep> steps;
    for (int i = 0; i < count; ++i) {
        const std::uint32_t kind = random.below(20);
        // Keys go to one side only, and things stand on the same floor.
        const double right = i % 5 == 3 ? 0 : random_length(random, 0.7);
        const double up = i % 5 == 1 ? 0 : random_length(random, 0.5);
        const double back = random_length(random, 2);
        glm::dvec3 point = middle + random_point(random, random.below(4) == 0 ? 40 : 4);
        if (i % 4 == 2) point[i / 4 % 3] = middle[i / 4 % 3];
        const double odd = nonsense[random.below(2)];
        if (kind < 10)
            steps.push_back(move_xy(right, up));
        else if (kind < 14)
            steps.push_back(move_z(back));
        else if (kind < 17)
            steps.push_back(next_mode());
        else if (kind < 19)
            steps.push_back(look_toward(point));
        else
            steps.push_back(i % 2 == 0 ? move_xy(right, odd) : move_z(odd));
    }
    return steps;
}

/// A stride, up to a hundred times as many turns at once, and a few random steps.
inline std::vector<ThreeModeStep> strides(Random& random, const glm::dvec3& middle)
{
    std::vector<ThreeModeStep> steps = random_steps(random, 10, middle);
    const double reach = std::pow(10.0F, random.uniform(2, 5));
    steps[0] = move_z(random_length(random, reach));
    steps[1] = move_xy(random_length(random, 100 * reach), random_length(random, reach));
    return steps;
}

/// From the observer to points: too far, by much or by little; the observer himself; too near; and in no direction.
inline std::vector<glm::dvec3> ways_too_near_or_far(Variation& vary)
{
    return {vary.near(glm::dvec3(2e15, -3e15, 1e15), 1e15),
            vary.near(glm::dvec3(-300, 50, 200), 40.0),
            {100, 50, -70},
            {0, 0, 0},
            {0.25, 0, 0.0625},
            {0.01, -0.02, 0.01},
            {1e-4, 2e-4, -1e-4},
            {3e-6, 0, 1e-6},
            {0, -4e-7, 3e-7}};
}

/// Each number of each call once as each of NaN and the infinities, in random order; after each a step that shows what
/// came of it.
inline std::vector<ThreeModeStep> steps_with_nonsense(Random& random)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<ThreeModeStep> nonsense;
    for (const double odd : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
        nonsense.insert(nonsense.end(), {move_xy(odd, 0.25), move_xy(0.5, odd), move_z(odd)});
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 point = random_point(random, 3);
            point[i] = odd;
            nonsense.push_back(look_toward(point));
        }
    }
    std::vector<ThreeModeStep> steps{move_xy(0, -0.0), move_z(0)};
    for (const ThreeModeStep& step : in_random_order(random, std::move(nonsense))) {
        steps.push_back(step);
        steps.push_back(steps.size() % 4 == 1 ? move_z(random_length(random, 1))
                                              : move_xy(random_length(random, 0.2), random_length(random, 0.1)));
    }
    return steps;
}

/// Cameras as they are made, with matrices that a student can work out by hand.
inline std::vector<ThreeModeSettings> beginnings()
{
    constexpr double pi = std::numbers::pi;
    return {{},
            {.azimuth = pi / 2},
            {.azimuth = pi, .distance = 2},
            {.azimuth = -pi / 2, .distance = 5},
            {.elevation = pi / 6, .distance = 4},
            {.elevation = -pi / 6, .distance = 4},
            {.attention = {1, 2, 3}, .distance = 7},
            {.attention = {-4, 0.5, 2}, .azimuth = pi / 4, .elevation = -pi / 4, .distance = 10},
            {.attention = {0, 1, 0}, .azimuth = 2.5, .elevation = 1.2, .distance = 2.5}};
}

/// A camera that is turned and leans, so that no axis of it is one of the world.
inline ThreeModeSettings leaning(CameraMode mode)
{
    return {.attention = {1, -2, 0.5}, .azimuth = 0.5, .elevation = 0.3, .distance = 4, .mode = mode};
}

/// Before the temple, from another side if inputs are to vary.
inline ThreeModeSettings before_the_temple(Variation& vary)
{
    return {.attention = {0, 1.25, 0},
            .azimuth = vary.near(0.62, 0.3),
            .elevation = vary.near(0.32, 0.06),
            .distance = 9,
            .max_distance = 40};
}

}
