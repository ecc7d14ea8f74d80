#pragma once

#include <string>
#include <umbral/core/random.hpp>

#include "../exposure.hpp"
#include "input_trial.hpp"

/// One hand draws a night sky: stars are clicks, constellations are strokes. What three programs see of it.
namespace umbral::interaction {

/// Strokes along the letters of a constellation, and clicks between them.
inline input::EventScript sky_script()
{
    // Orion: shoulders, belt, feet, head, and the bow.
    static constexpr glm::dvec2 figure[][9] = {
        {{82, 66}, {104, 118}, {92, 182}},   {{152, 74}, {128, 112}, {148, 174}},
        {{82, 66}, {112, 40}, {152, 74}},    {{104, 118}, {116, 115}, {128, 112}},
        {{92, 182}, {120, 190}, {148, 174}}, {{152, 74}, {196, 88}, {204, 60}, {198, 32}},
        {{196, 88}, {200, 118}, {188, 144}},
    };
    input::EventScript script;
    Random random(4);
    double time = 0.1;
    const auto happens = [&](double seconds, const input::Event& event) { script.push_back({time += seconds, event}); };
    const auto click = [&](glm::dvec2 place) {
        happens(0.010, input::CursorMove{place});
        happens(0.004, input::MouseButton{.button = GLFW_MOUSE_BUTTON_RIGHT});
        happens(0.003, input::MouseButton{.button = GLFW_MOUSE_BUTTON_RIGHT, .pressed = false});
    };
    for (const auto& stroke : figure) {
        happens(0.02, input::CursorMove{stroke[0]});
        happens(0.01, input::MouseButton{.button = GLFW_MOUSE_BUTTON_LEFT});
        for (int i = 1; i < 9 && stroke[i] != glm::dvec2(0); ++i) {
            const double length = glm::length(stroke[i] - stroke[i - 1]);
            for (double along = 3; along < length; along += 3)
                happens(0.004, input::CursorMove{glm::mix(stroke[i - 1], stroke[i], along / length)});
            happens(0.004, input::CursorMove{stroke[i]});
        }
        happens(0.01, input::MouseButton{.button = GLFW_MOUSE_BUTTON_LEFT, .pressed = false});
        for (int i = 0; i < 9; ++i) {
            const double x = 8 + 224 * random.uniform_double();
            click({x, 8 + 224 * random.uniform_double()});
        }
    }
    return script;
}

/// A star where a button goes down, and a thread of light along the way on which the left one is held.
class SkyPainter {
public:
    void see(const MouseState& state)
    {
        const unsigned pressed = state.buttons & ~last_.buttons;
        if ((pressed & 2U) != 0) exposure.add(state.cursor, star_light(state.cursor));
        if ((state.buttons & last_.buttons & 1U) != 0) thread(last_.cursor, state.cursor);
        if ((pressed & 1U) != 0) exposure.add(state.cursor, corner_light);
        if ((last_.buttons & ~state.buttons & 1U) != 0) exposure.add(state.cursor, corner_light);
        last_ = state;
    }

    Exposure exposure;

private:
    inline static const glm::dvec3 corner_light = 1.6 * glm::mix(glm::dvec3(1), light_color(0.56), 0.6);

    /// Stars are of different brightness, and from bluish to reddish.
    static glm::dvec3 star_light(glm::dvec2 place)
    {
        const double warmth = glm::fract(0.37 * place.x + 0.61 * place.y);
        const glm::dvec3 tint = light_color(warmth < 0.6 ? 0.58 : 0.07);
        const double brightness = 0.15 + 0.9 * std::pow(glm::fract(0.73 * place.x + 0.19 * place.y), 3);
        return brightness * glm::mix(glm::dvec3(1), tint, 0.55);
    }

    void thread(glm::dvec2 from, glm::dvec2 to)
    {
        const double length = glm::length(to - from);
        if (!(length < 1e3)) return;
        for (double along = 0; along < length; along += 1.5)
            exposure.add(glm::mix(from, to, along / length), 0.16 * light_color(0.6));
    }

    MouseState last_;
};

}
