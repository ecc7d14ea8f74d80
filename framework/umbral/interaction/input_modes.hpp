#pragma once

#include <deque>
#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/input/glfw.hpp>

namespace umbral::interaction {

/// What the mouse is like at one moment (estado de un dispositivo).
struct MouseState {
    glm::dvec2 cursor{0};  ///< screen coordinates from the window's upper left corner, y downwards; may lie outside
    unsigned buttons =
        0;  ///< bit b, of value 2^b, is set while GLFW's button b (0 left, 1 right, 2 middle, … 7) is down
};

/// A way in which the state of mouse or keyboard changes.
enum class InputKind { button_pressed, button_released, cursor_moved, scrolled, key_pressed, key_released };

/// A change of state (suceso, evento).
struct InputEvent {
    InputKind kind = InputKind::button_pressed;
    int code = 0;          ///< GLFW's number of the button or key; 0 for other kinds
    double time = 0;       ///< glfwGetTime() when GLFW delivered it
    glm::dvec2 change{0};  ///< cursor_moved: from where it was before; scrolled: GLFW's offsets; else 0
    MouseState after{};    ///< right after the event
};

/// What a window's user pointer points to while its input is read; one for each window, and empty at first. Yours to
/// use: nobody else looks at it.
struct InputMemory {
    std::deque<InputEvent> pending;      ///< events that nobody has taken yet, oldest first
    MouseState state;                    ///< after the last event
    std::optional<InputKind> requested;  ///< what a request waits for
    std::optional<InputEvent> answer;    ///< the first event that it waited for
};

/// Registers callbacks for mouse buttons, cursor, scrolling and keys, which remember every event of this window from
/// now on. Buttons may be down already, and the cursor may be anywhere. A key that repeats because it is held changes
/// no state: it is no event. Processes no events.
void install_input(GLFWwindow* window);

/// **Sampling** (modo de muestreo): the state after the last event that GLFW has delivered. Waits for nothing,
/// processes no events, and takes none out of the queue: what went down and up again since the last sample is not seen.
[[nodiscard]] MouseState sample_mouse(GLFWwindow* window);

/// **Request** (modo petición): waits for the next event of a kind, and returns it.
///
/// What happened before the request is no answer, even if GLFW has not delivered it yet: calls glfwPollEvents once,
/// first. Then calls glfwWaitEvents, and nothing else that processes events, until an event of this kind has come, or
/// glfwWindowShouldClose says that none need come. Of several that one wait brings, the first is the answer. Without
/// one: std::nullopt, and no wait if the window was to close after the poll already. Takes nothing out of the queue:
/// all events that come meanwhile, the answer too, are pending behind it.
[[nodiscard]] std::optional<InputEvent> request_event(GLFWwindow* window, InputKind kind);

/// **Event queue** (modo cola de eventos): takes the oldest event that nobody has taken yet; std::nullopt if there is
/// none. Waits for nothing and processes no events: whoever reads the queue calls glfwPollEvents now and then. No event
/// is lost, and none comes twice. Course: "modos de entrada".
[[nodiscard]] std::optional<InputEvent> next_event(GLFWwindow* window);

}
