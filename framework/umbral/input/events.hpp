#pragma once

#include <glm/glm.hpp>
#include <string>
#include <variant>
#include <vector>

/// What a user does with mouse, keyboard and window, as data: written by hand, read from a script, or drawn at random.
///
/// Places are in screen coordinates from the window's upper left corner, y downwards, as GLFW gives them. Buttons and
/// keys have GLFW's numbers.
namespace umbral::input {

/// A mouse button goes down or up. With a place, the pointer moves there first.
struct MouseButton {
    int button = 0;  ///< GLFW_MOUSE_BUTTON_…
    bool pressed = true;
    bool placed = false;
    glm::dvec2 place{0};
    friend bool operator==(const MouseButton&, const MouseButton&) = default;
};

/// The pointer moves to a place, which may lie outside the window while a button is held.
struct CursorMove {
    glm::dvec2 place{0};
    friend bool operator==(const CursorMove&, const CursorMove&) = default;
};

/// Steps of a wheel, or parts of steps of a touchpad: x to the left and right, y away from the user (positive) and
/// towards.
struct Scroll {
    glm::dvec2 offset{0};
    friend bool operator==(const Scroll&, const Scroll&) = default;
};

/// A key goes down, up, or is repeated because it is held.
struct Key {
    enum class Action { release = 0, press = 1, repeat = 2 };
    int key = 0;  ///< GLFW_KEY_…
    Action action = Action::press;
    friend bool operator==(const Key&, const Key&) = default;
};

/// A character that an input method composed. (Those that single keys produce follow from the keys.)
struct Character {
    char32_t code_point = 0;
    friend bool operator==(const Character&, const Character&) = default;
};

/// The window gets another size, in screen coordinates; 0 x 0 when some systems minimise it.
struct Resize {
    glm::ivec2 size{0};
    friend bool operator==(const Resize&, const Resize&) = default;
};

/// The window gets or loses the keyboard. All keys and buttons that were held count as released when it loses it.
struct Focus {
    bool gained = true;
    friend bool operator==(const Focus&, const Focus&) = default;
};

/// The pointer enters or leaves the window's content.
struct CursorEnter {
    bool entered = true;
    friend bool operator==(const CursorEnter&, const CursorEnter&) = default;
};

/// The window is minimised, or restored.
struct Iconify {
    bool iconified = true;
    friend bool operator==(const Iconify&, const Iconify&) = default;
};

/// The window's content has to be drawn again.
struct Refresh {
    friend bool operator==(const Refresh&, const Refresh&) = default;
};

/// The user asks the window to close.
struct Close {
    friend bool operator==(const Close&, const Close&) = default;
};

using Event =
    std::variant<MouseButton, CursorMove, Scroll, Key, Character, Resize, Focus, CursorEnter, Iconify, Refresh, Close>;

struct TimedEvent {
    double time = 0;  ///< seconds since the script began
    Event event;
    friend bool operator==(const TimedEvent&, const TimedEvent&) = default;
};

/// Events in the order in which they happen; times never go back.
using EventScript = std::vector<TimedEvent>;

}
