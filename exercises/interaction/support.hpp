#pragma once

#include <cmath>
#include <cstdint>
#include <kit/magnitude.hpp>
#include <limits>
#include <umbral/core/random.hpp>
#include <umbral/interaction/orbit_camera.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// What the drivers of interaction share: what a user does to a camera.
namespace umbral::interaction {

struct CameraEvent {
    enum class Kind { drag, scroll, resize, reset };
    Kind kind = Kind::drag;
    double a = 0;  ///< right, steps, or width
    double b = 0;  ///< up, or height
};

inline CameraEvent drag(double right, double up) { return {CameraEvent::Kind::drag, right, up}; }
inline CameraEvent scroll(double steps) { return {CameraEvent::Kind::scroll, steps}; }
inline CameraEvent resize(int width, int height)
{
    return {CameraEvent::Kind::resize, static_cast<double>(width), static_cast<double>(height)};
}
inline CameraEvent reset() { return {CameraEvent::Kind::reset}; }

inline void apply(OrbitCamera& camera, const CameraEvent& event)
{
    switch (event.kind) {
        case CameraEvent::Kind::drag: return camera.drag(event.a, event.b);
        case CameraEvent::Kind::scroll: return camera.scroll(event.a);
        case CameraEvent::Kind::resize: return camera.resize(static_cast<int>(event.a), static_cast<int>(event.b));
        case CameraEvent::Kind::reset: return camera.reset();
    }
}

/// The same as questions (ask.hpp).
inline void apply(Recorder& out, OrbitCamera& camera, const CameraEvent& event)
{
    switch (event.kind) {
        case CameraEvent::Kind::drag: return ask<&OrbitCamera::drag>(out, camera, event.a, event.b);
        case CameraEvent::Kind::scroll: return ask<&OrbitCamera::scroll>(out, camera, event.a);
        case CameraEvent::Kind::resize:
            return ask<&OrbitCamera::resize>(out, camera, static_cast<int>(event.a), static_cast<int>(event.b));
        case CameraEvent::Kind::reset: return ask<&OrbitCamera::reset>(out, camera);
    }
}

/// Another camera to begin with, if inputs are to vary: its limits are the same, and it is as far from them.
inline OrbitCameraSettings varied(Variation& vary, OrbitCameraSettings settings)
{
    settings.target = vary.near(settings.target, 0.5);
    settings.distance = vary.scaled(settings.distance, 1.2F);
    settings.yaw = vary.near(settings.yaw, 0.4);
    settings.pitch = vary.near(settings.pitch, 0.1);
    settings.viewport_height = vary.near(settings.viewport_height, settings.viewport_height / 5);
    return settings;
}

/// A number of 64ths of a pixel in [-reach, reach): exact, whatever is added to it.
inline double random_pixels(Random& random, double reach)
{
    return std::floor(64 * reach * (2 * random.uniform_double() - 1)) / 64;
}

/// A camera somewhere within 3 of the origin, 2 to 8 away from its target, in any unit of length; of four one stands at
/// a limit of its pitch, and of four one may come closer to 90 degrees than others.
inline OrbitCameraSettings random_settings(Random& random)
{
    OrbitCameraSettings settings;
    const double unit = random_unit(random, -8, 8);
    settings.target = 3 * unit * glm::dvec3(random.in_cube());
    settings.distance = unit * (2 + 6 * random.uniform_double());
    settings.yaw = 6 * random.uniform_double() - 3;
    settings.pitch = 2 * random.uniform_double() - 1;
    settings.min_distance = 0.5 * unit;
    settings.max_distance = 20 * unit;
    settings.max_pitch = 1.05 + 0.45 * random.uniform_double();
    if (random.below(4) == 0) settings.max_pitch = 1.56;
    if (random.below(4) == 0) settings.pitch = std::copysign(settings.max_pitch, settings.pitch);
    settings.viewport_height = 300 + static_cast<int>(random.below(900));
    return settings;
}

/// A new size, or one time in three one that is none.
inline CameraEvent random_resize(Random& random, int width, int height)
{
    switch (random.below(15)) {
        case 0: return resize(0, 0);
        case 1: return resize(0, height);
        case 2: return resize(width, 0);
        case 3: return resize(-width, height);
        case 4: return resize(width, -height);
        default: return resize(width, height);
    }
}

/// A session: mostly drags, then the wheel, and now and then a new size of the window (or none of it), a reset, and
/// nonsense.
inline std::vector<CameraEvent> random_session(Random& random, int count)
{
    constexpr double nonsense[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
    std::vector<CameraEvent> events;
    for (int i = 0; i < count; ++i) {
        const std::uint32_t kind = random.below(20);
        const double x = random_pixels(random, 200);
        const double y = random_pixels(random, 200);
        const double steps = std::floor(16 * (6 * random.uniform_double() - 3)) / 16;
        const int width = 200 + static_cast<int>(random.below(1500));
        const int height = 200 + static_cast<int>(random.below(1000));
        const double odd = nonsense[random.below(2)];
        if (kind < 12)
            events.push_back(drag(x, y));
        else if (kind < 17)
            events.push_back(scroll(steps));
        else if (kind == 17)
            events.push_back(random_resize(random, width, height));
        else if (kind == 18)
            events.push_back(random.below(2) == 0 ? drag(x, odd) : scroll(odd));
        else if (i % 4 == 0)
            events.push_back(reset());
    }
    return events;
}

}
