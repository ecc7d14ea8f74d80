#pragma once

#include <array>
#include <bitset>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <umbral/core/student_error.hpp>
#include <umbral/input/headless.hpp>
#include <vector>

/// What the virtual window is at this moment. Private to libumbral-glfw, which exports none of it.
struct GLFWwindow {
    std::string title;
    glm::ivec2 size{0};
    glm::ivec2 position{0};
    glm::dvec2 cursor{0};
    std::map<int, int> attributes;   ///< by GLFW_RESIZABLE …, from the hints
    std::map<int, int> input_modes;  ///< by GLFW_CURSOR …
    void* user_pointer = nullptr;
    bool should_close = false;
    float opacity = 1;
    std::array<int, GLFW_KEY_LAST + 1> keys{};
    std::array<int, GLFW_MOUSE_BUTTON_LAST + 1> buttons{};

    struct {
        GLFWwindowposfun position;
        GLFWwindowsizefun size;
        GLFWwindowclosefun close;
        GLFWwindowrefreshfun refresh;
        GLFWwindowfocusfun focus;
        GLFWwindowiconifyfun iconify;
        GLFWwindowmaximizefun maximize;
        GLFWframebuffersizefun framebuffer_size;
        GLFWwindowcontentscalefun content_scale;
        GLFWkeyfun key;
        GLFWcharfun character;
        GLFWcharmodsfun character_mods;
        GLFWmousebuttonfun mouse_button;
        GLFWcursorposfun cursor_position;
        GLFWcursorenterfun cursor_enter;
        GLFWscrollfun scroll;
        GLFWdropfun drop;
    } callbacks{};
};

namespace umbral::input::headless {

/// In keys and buttons, beside GLFW_RELEASE and GLFW_PRESS: released, but "sticky" until it is asked for.
inline constexpr int stuck = 3;

/// What the program itself caused to a window, as by glfwSetWindowSize: delivered with the next poll.
struct OwnEvent {
    GLFWwindow* window;
    Event event;
};

/// Everything behind GLFW's functions.
struct State {
    bool session = false;
    bool initialised = false;
    bool delivering = false;  ///< a callback may be running
    EventScript script;
    std::size_t next_event = 0;
    HeadlessSettings settings;
    Usage usage;
    std::deque<OwnEvent> pending;
    bool woken = false;  ///< by glfwPostEmptyEvent
    bool asked_to_close = false;
    std::size_t polls_after_closing = 0;
    double now = 0;                                    ///< seconds of the script
    double time_offset = 0;                            ///< what glfwSetTime added
    std::vector<std::unique_ptr<GLFWwindow>> windows;  ///< in the order in which they were made
    GLFWwindow* current = nullptr;                     ///< of glfwMakeContextCurrent
    int swap_interval = 0;
    std::map<int, int> hints;
    std::string clipboard;
    int error = GLFW_NO_ERROR;
    std::string error_text;
    std::string told_error_text;  ///< kept alive for whoever asked
    GLFWerrorfun error_callback = nullptr;
    GLFWmonitorfun monitor_callback = nullptr;
    GLFWjoystickfun joystick_callback = nullptr;
};

State& state();

/// Is GLFW initialised? If not, reports GLFW_NOT_INITIALIZED.
[[nodiscard]] bool ready();

/// Reports an error as GLFW does: kept for glfwGetError, and told to the error callback.
void report(int code, const std::string& text);

/// Ends the case: the program uses GLFW as its documentation forbids, or as no script can serve.
[[noreturn]] void give_up(const std::string& text);

/// Is this one of the program's windows?
[[nodiscard]] bool exists(const GLFWwindow* window);

/// One of the program's windows. Where GLFW would crash (a null or a foreign pointer), a StudentError says so.
GLFWwindow& window_of(GLFWwindow* handle, const char* function);

/// Throws a StudentError if a callback is running: GLFW's documentation says "must not be called from a callback" of
/// this function.
void not_from_a_callback(const char* function);

[[nodiscard]] std::map<int, int> default_hints();

/// The size in pixels of a window's framebuffer.
[[nodiscard]] glm::ivec2 framebuffer_size(const GLFWwindow& window);

/// The modifier bits that the keys held now give.
[[nodiscard]] int held_modifiers(const GLFWwindow& window);

/// Changes the window's state as the event says, and calls the callbacks that hear of it.
void deliver(GLFWwindow& window, const Event& event);

/// Puts a new value where the old one was, and returns the old one.
template <class Callback>
Callback exchange_callback(Callback& held, Callback given)
{
    const Callback before = held;
    held = given;
    return before;
}

}
