#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <umbral/input/glfw.hpp>
#include <umbral/input/names.hpp>

/// Keys and buttons as codes of recorded events, so that reports name them: "key S, press", and not numbers of GLFW's.
namespace umbral {

namespace input_words {
inline constexpr int first_button = 100;
inline constexpr int first_key = 1000;
inline constexpr int most_keys = 4096;  ///< no key of GLFW's has so large a number
inline constexpr std::array<const char*, 4> actions = {"release", "press", "repeat", "unknown action"};

/// A line of "<value>.names".
inline std::string line(float code, const std::string& name, std::string_view numbers)
{
    return std::to_string(static_cast<int>(code)) + " " + name + (numbers.empty() ? "" : ": ") + std::string(numbers) +
           "\n";
}
}

/// The code of what was done to a key (GLFW_KEY_…; GLFW_RELEASE, GLFW_PRESS or GLFW_REPEAT). Other numbers have codes,
/// too: no known key's and action's.
[[nodiscard]] inline float key_code(int key, int action)
{
    const int last = static_cast<int>(input_words::actions.size()) - 1;
    const int known = action < 0 || action > last ? last : action;
    const int place = std::clamp(key, GLFW_KEY_UNKNOWN, input_words::most_keys) - GLFW_KEY_UNKNOWN;
    return static_cast<float>(input_words::first_key + (last + 1) * place + known);
}

/// The code of what was done to a button of the mouse (GLFW_MOUSE_BUTTON_…).
[[nodiscard]] inline float button_code(int button, bool pressed)
{
    const int place = std::clamp(button, -1, GLFW_MOUSE_BUTTON_LAST + 1) + 1;
    return static_cast<float>(input_words::first_button + 2 * place + (pressed ? 1 : 0));
}

/// What the codes of keys are called, as lines for "<value>.names". `numbers`: the names of the numbers that stand
/// behind the code ("modifiers"), if they have any.
[[nodiscard]] inline std::string key_names(std::string_view numbers = "")
{
    std::string text;
    for (int key = GLFW_KEY_UNKNOWN; key <= GLFW_KEY_LAST; ++key) {
        const std::string name = key == GLFW_KEY_UNKNOWN ? "unknown key" : "key " + input::name_of_key(key);
        if (name == "key ") continue;
        for (int action = 0; action < static_cast<int>(input_words::actions.size()); ++action)
            text += input_words::line(key_code(key, action),
                                      name + ", " + input_words::actions.at(static_cast<std::size_t>(action)), numbers);
    }
    return text;
}

/// The same of the codes of buttons.
[[nodiscard]] inline std::string button_names(std::string_view numbers = "")
{
    std::string text;
    for (int button = 0; button <= GLFW_MOUSE_BUTTON_LAST; ++button)
        for (const bool pressed : {false, true})
            text += input_words::line(button_code(button, pressed),
                                      input::name_of_button(button) + " button, " + (pressed ? "press" : "release"),
                                      numbers);
    return text;
}

}
