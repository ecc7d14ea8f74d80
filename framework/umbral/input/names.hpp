#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Names of keys and buttons in event scripts.
namespace umbral::input {

/// GLFW's number of a key: "A" to "Z", "0" to "9", "F1" to "F25", "KP_0" to "KP_9", signs as "+" or ";" where the US
/// keyboard has them on a key of their own ("-" and "="), and long names as "LEFT_SHIFT", "ESCAPE", "PAGE_UP". Case
/// does not matter. None for other texts.
[[nodiscard]] std::optional<int> key_of(std::string_view name);

/// The name that gives this key back; empty for a number that is no key of GLFW's.
[[nodiscard]] std::string name_of_key(int key);

/// "left", "right", "middle", or "4" to "8", as a number from 0.
[[nodiscard]] std::optional<int> button_of(std::string_view name);
[[nodiscard]] std::string name_of_button(int button);

/// The character that a key produces on a US keyboard, with or without Shift; 0 for keys that produce none.
[[nodiscard]] char character_of(int key, bool shift);

}
