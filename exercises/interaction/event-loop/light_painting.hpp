#pragma once

#include <cmath>
#include <numbers>

#include "../exposure.hpp"
#include "scripted_program.hpp"

/// A long exposure of a window in the dark: every frame that is shown adds its lights to the picture, so that frames
/// without need shine, and missing ones are gaps.
namespace umbral::interaction {

/// Lights whose place follows from the pointer and from how often the scene was updated.
class LightPainter final : public ScriptedProgram {
public:
    /// What is seen of a scene: its lights, added to an exposure.
    using Lights = void (*)(Exposure&, int updates, glm::dvec2 pointer);

    /// `rest`: the animation ends at each update whose number this divides; 0: never.
    LightPainter(Lights lights, int rest) : ScriptedProgram({}), lights_(lights), rest_(rest) {}

    void draw() override
    {
        drawn_updates_ = updates_;
        drawn_pointer_ = pointer;
        drawn_ = true;
    }
    void update() override
    {
        ++updates_;
        flags.redraw = true;
        if (rest_ > 0 && updates_ % rest_ == 0) flags.animate = false;
    }
    /// The screen shows what was drawn last.
    void shown()
    {
        if (drawn_) lights_(exposure, drawn_updates_, drawn_pointer_);
    }

    Exposure exposure;

private:
    Lights lights_;
    int rest_;
    int updates_ = 0;
    int drawn_updates_ = 0;
    bool drawn_ = false;
    glm::dvec2 drawn_pointer_{0};
};

/// For the loop that waits: the pointer is the only light, and the hand draws a rose of five petals.
inline void pointer_light(Exposure& exposure, int, glm::dvec2 pointer)
{
    const glm::dvec2 out = pointer - exposure_middle;
    exposure.add(pointer, light_color(0.55 + 0.0035 * glm::length(out)));
}

inline input::EventScript hand_draws_a_rose()
{
    constexpr int steps = 180;
    input::EventScript script;
    for (int i = 0; i < steps; ++i) {
        const double turns = double(i) / steps;
        const double radius = 104 * std::cos(5 * std::numbers::pi * turns);
        const glm::dvec2 place = exposure_middle + radius * on_circle(0.5 * turns + 0.25);
        script.push_back({0.1 + 0.05 * i, input::CursorMove{place}});
        // Two motions at one moment need one frame, and a key without a meaning none.
        if (i % 30 == 11) script.push_back({0.1 + 0.05 * i, input::CursorMove{place + 3.0 * on_circle(turns)}});
        if (i % 30 == 20) script.push_back({0.12 + 0.05 * i, input::Key{GLFW_KEY_B}});
    }
    script.push_back({10, input::Key{GLFW_KEY_ESCAPE}});
    return script;
}

/// For the loop that always moves: three lights on epitrochoids, one behind the other.
inline void planet_lights(Exposure& exposure, int updates, glm::dvec2)
{
    for (int k = 0; k < 3; ++k) {
        const double turns = updates / 132.0 + k / 3.0;
        const glm::dvec2 place = exposure_middle + 66.0 * on_circle(turns / 1.0) + 36.0 * on_circle(-5 * turns + 0.5);
        exposure.add(place, light_color(0.02 + 0.09 * k + 0.08 * std::sin(2 * std::numbers::pi * turns)));
    }
}

/// For the loop that switches: a light that goes round the pointer, which moves on while it rests.
inline void moon_light(Exposure& exposure, int updates, glm::dvec2 pointer)
{
    const double turns = updates / 30.0;
    const glm::dvec3 color = light_color(0.28 + 0.0016 * (pointer.x + 0.4 * pointer.y));
    exposure.add(pointer + 25.0 * on_circle(turns - 0.03), color);
    exposure.add(pointer, 0.35 * color);
}

inline input::EventScript moon_and_hand()
{
    input::EventScript script;
    double time = 0;
    for (int corner = 0; corner < 5; ++corner) {
        const glm::dvec2 from = exposure_middle + 84.0 * on_circle(0.25 + 0.4 * corner);
        const glm::dvec2 to = exposure_middle + 84.0 * on_circle(0.25 + 0.4 * (corner + 1));
        script.push_back({time += 0.05, input::CursorMove{from}});
        script.push_back({time += 0.05, input::Key{GLFW_KEY_A}});
        time += 0.7;  // a turn of 30 updates
        for (int i = 1; i < 22; ++i) script.push_back({time += 0.02, input::CursorMove{glm::mix(from, to, i / 22.0)}});
    }
    script.push_back({time + 0.1, input::Key{GLFW_KEY_ESCAPE}});
    return script;
}

}
