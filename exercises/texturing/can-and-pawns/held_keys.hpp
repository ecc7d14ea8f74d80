#pragma once

#include <kit/input_words.hpp>
#include <string>

#include "program.hpp"

/// Case of rubric line 6: what the keys of the light do: pressed, held, with Shift, up to the highest latitude, and
/// outside the mode.
namespace umbral::texturing {

/// A key that is held until so many events of it have come: it is pressed, repeated, and released, within 0.06 s, so
/// that a program that polls ten times a second has drawn it 0.18 s after `time`.
inline std::string held(double time, const std::string& key, int events)
{
    std::string script;
    for (int i = 0; i <= events; ++i) {
        const char* const action = i == 0 ? " press\n" : i < events ? " repeat\n" : " release\n";
        script += std::to_string(time + 0.06 * i / (events + 1)) + " key " + key + action;
    }
    return script;
}

inline std::string keys_of_light()
{
    // The mode is left early, so that most of what follows shows whether the light stayed as the keys had turned it.
    return held(0.05, "X", 1) + held(0.2, "4", 4) + "0.40 key X press\n0.405 key X release\n" + held(0.41, "A", 3) +
           "0.60 key LEFT_SHIFT press\n0.61 key Z press\n0.62 key Z release\n0.63 key C press\n0.64 key C repeat\n"
           "0.65 key C release\n0.66 key LEFT_SHIFT release\n" +
           held(0.8, "4", 1) + held(0.85, "A", 1) + held(1.0, "4", 1) + held(1.2, "RIGHT", 3) + held(1.4, "A", 11) +
           held(1.6, "Z", 1) + held(1.8, "X", 1) + held(2.0, "P", 1);
}

inline void lights_of_program(Case& c, Recorder& out)
{
    const std::string script = keys_of_light();
    const Session session(script, {.start = first_pose(c.vary)});
    out.columns("lights", "directional lights, positional lights, direction/3, place/3, colour/3, colour/3");
    for (int i = 1; i <= 21; i += 2) {
        const double time = 0.1 * i + 0.08;
        tell(out, script, time);
        const Frame frame = session.frame_at(time);
        out.append("lights", std::span<const float>(frame.lights));
        out.append("mode", frame.earlier ? 1.0F : 0.0F);
    }
    tell(out, script, 3);
    out.text("passed on.names", key_names("modifiers"));
    for (const auto& [key, action, mods] : session.earlier().keys) {
        // Of these the interface leaves open where they go.
        const bool of_light = key == GLFW_KEY_A || key == GLFW_KEY_Z || key == GLFW_KEY_X || key == GLFW_KEY_C;
        if (key == GLFW_KEY_4 || (of_light && action == GLFW_RELEASE)) continue;
        out.append("passed on", glm::vec2(key_code(key, action), mods));
    }
}

}
