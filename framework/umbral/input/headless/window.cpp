#include "state.hpp"

// Making the window, its attributes, and what a program may do to it. What the window system would answer comes as an
// event with the next poll.

namespace umbral::input::headless {
namespace {

constexpr std::size_t most_windows = 2;

/// Attributes that a program may change while the window lives.
constexpr std::array changeable = {GLFW_DECORATED, GLFW_RESIZABLE, GLFW_FLOATING, GLFW_AUTO_ICONIFY,
                                   GLFW_FOCUS_ON_SHOW};

bool is_known(const std::map<int, int>& known, int number, const char* what)
{
    if (known.contains(number)) return true;
    report(GLFW_INVALID_ENUM, "Invalid " + std::string(what) + " " + std::to_string(number));
    return false;
}

std::unique_ptr<GLFWwindow> new_window(const std::map<int, int>& hints, glm::ivec2 size, const char* title)
{
    auto window = std::make_unique<GLFWwindow>();
    window->title = title;
    window->size = size;
    window->cursor = state().settings.pointer;
    window->attributes = hints;
    window->attributes[GLFW_ICONIFIED] = 0;
    window->attributes[GLFW_HOVERED] = 1;
    window->input_modes[GLFW_CURSOR] = GLFW_CURSOR_NORMAL;
    return window;
}

/// Writes a pair where it is wanted.
template <class Number, class Pair>
void give(Number* x, Number* y, const Pair& pair)
{
    if (x != nullptr) *x = static_cast<Number>(pair.x);
    if (y != nullptr) *y = static_cast<Number>(pair.y);
}

void soon(GLFWwindow* window, const Event& event) { state().pending.push_back({window, event}); }

}

std::map<int, int> default_hints()
{
    return {{GLFW_FOCUSED, 1},
            {GLFW_RESIZABLE, 1},
            {GLFW_VISIBLE, 1},
            {GLFW_DECORATED, 1},
            {GLFW_AUTO_ICONIFY, 1},
            {GLFW_FLOATING, 0},
            {GLFW_MAXIMIZED, 0},
            {GLFW_CENTER_CURSOR, 1},
            {GLFW_TRANSPARENT_FRAMEBUFFER, 0},
            {GLFW_FOCUS_ON_SHOW, 1},
            {GLFW_SCALE_TO_MONITOR, 0},
            {GLFW_RED_BITS, 8},
            {GLFW_GREEN_BITS, 8},
            {GLFW_BLUE_BITS, 8},
            {GLFW_ALPHA_BITS, 8},
            {GLFW_DEPTH_BITS, 24},
            {GLFW_STENCIL_BITS, 8},
            {GLFW_ACCUM_RED_BITS, 0},
            {GLFW_ACCUM_GREEN_BITS, 0},
            {GLFW_ACCUM_BLUE_BITS, 0},
            {GLFW_ACCUM_ALPHA_BITS, 0},
            {GLFW_AUX_BUFFERS, 0},
            {GLFW_STEREO, 0},
            {GLFW_SAMPLES, 0},
            {GLFW_SRGB_CAPABLE, 0},
            {GLFW_DOUBLEBUFFER, 1},
            {GLFW_REFRESH_RATE, GLFW_DONT_CARE},
            {GLFW_CLIENT_API, GLFW_OPENGL_API},
            {GLFW_CONTEXT_CREATION_API, GLFW_NATIVE_CONTEXT_API},
            {GLFW_CONTEXT_VERSION_MAJOR, 1},
            {GLFW_CONTEXT_VERSION_MINOR, 0},
            {GLFW_CONTEXT_REVISION, 0},
            {GLFW_CONTEXT_ROBUSTNESS, GLFW_NO_ROBUSTNESS},
            {GLFW_CONTEXT_RELEASE_BEHAVIOR, GLFW_ANY_RELEASE_BEHAVIOR},
            {GLFW_CONTEXT_NO_ERROR, 0},
            {GLFW_OPENGL_FORWARD_COMPAT, 0},
            {GLFW_OPENGL_DEBUG_CONTEXT, 0},
            {GLFW_OPENGL_PROFILE, GLFW_OPENGL_ANY_PROFILE}};
}

}

using namespace umbral::input;
using namespace umbral::input::headless;

extern "C" {

void glfwDefaultWindowHints()
{
    if (ready()) state().hints = default_hints();
}

void glfwWindowHint(int hint, int value)
{
    if (ready() && is_known(default_hints(), hint, "window hint")) state().hints[hint] = value;
}

void glfwWindowHintString(int hint, const char*)
{
    if (ready() && hint != GLFW_COCOA_FRAME_NAME && hint != GLFW_X11_CLASS_NAME && hint != GLFW_X11_INSTANCE_NAME)
        report(GLFW_INVALID_ENUM, "Invalid window hint string " + std::to_string(hint));
}

GLFWwindow* glfwCreateWindow(int width, int height, const char* title, GLFWmonitor*, GLFWwindow*)
{
    if (!ready()) return nullptr;
    not_from_a_callback("glfwCreateWindow");
    if (width <= 0 || height <= 0) {
        report(GLFW_INVALID_VALUE, "Invalid window size " + std::to_string(width) + "x" + std::to_string(height));
        return nullptr;
    }
    State& now = state();
    if (now.windows.size() == most_windows)
        give_up(
            "glfwCreateWindow: headless GLFW has two windows, and both exist already; destroy one before you make "
            "another");
    return now.windows.emplace_back(new_window(now.hints, {width, height}, title == nullptr ? "" : title)).get();
}

void glfwDestroyWindow(GLFWwindow* handle)
{
    if (!ready() || handle == nullptr) return;
    not_from_a_callback("glfwDestroyWindow");
    (void)window_of(handle, "glfwDestroyWindow");
    if (state().current == handle) state().current = nullptr;
    std::erase_if(state().pending, [&](const OwnEvent& own) { return own.window == handle; });
    std::erase_if(state().windows, [&](const auto& window) { return window.get() == handle; });
}

int glfwWindowShouldClose(GLFWwindow* handle)
{
    return ready() && window_of(handle, "glfwWindowShouldClose").should_close ? GLFW_TRUE : GLFW_FALSE;
}

void glfwSetWindowShouldClose(GLFWwindow* handle, int value)
{
    if (ready()) window_of(handle, "glfwSetWindowShouldClose").should_close = value != 0;
}

void glfwSetWindowTitle(GLFWwindow* handle, const char* title)
{
    if (ready()) window_of(handle, "glfwSetWindowTitle").title = title == nullptr ? "" : title;
}

void glfwGetWindowPos(GLFWwindow* handle, int* x, int* y)
{
    give(x, y, ready() ? window_of(handle, "glfwGetWindowPos").position : glm::ivec2(0));
}

void glfwSetWindowPos(GLFWwindow* handle, int x, int y)
{
    if (ready()) window_of(handle, "glfwSetWindowPos").position = {x, y};
}

void glfwGetWindowSize(GLFWwindow* handle, int* width, int* height)
{
    give(width, height, ready() ? window_of(handle, "glfwGetWindowSize").size : glm::ivec2(0));
}

void glfwSetWindowSize(GLFWwindow* handle, int width, int height)
{
    if (!ready()) return;
    (void)window_of(handle, "glfwSetWindowSize");
    if (width >= 0 && height >= 0) soon(handle, Resize{{width, height}});
}

void glfwGetFramebufferSize(GLFWwindow* handle, int* width, int* height)
{
    give(width, height, ready() ? framebuffer_size(window_of(handle, "glfwGetFramebufferSize")) : glm::ivec2(0));
}

void glfwGetWindowContentScale(GLFWwindow* handle, float* x, float* y)
{
    if (ready()) (void)window_of(handle, "glfwGetWindowContentScale");
    give(x, y, ready() ? state().settings.content_scale : glm::dvec2(0));
}

float glfwGetWindowOpacity(GLFWwindow* handle)
{
    return ready() ? window_of(handle, "glfwGetWindowOpacity").opacity : 1;
}

void glfwSetWindowOpacity(GLFWwindow* handle, float opacity)
{
    if (!ready()) return;
    GLFWwindow& window = window_of(handle, "glfwSetWindowOpacity");
    if (opacity >= 0 && opacity <= 1)
        window.opacity = opacity;
    else
        report(GLFW_INVALID_VALUE, "Invalid window opacity " + std::to_string(opacity));
}

void glfwIconifyWindow(GLFWwindow* handle)
{
    if (!ready()) return;
    (void)window_of(handle, "glfwIconifyWindow");
    soon(handle, Iconify{true});
}

void glfwRestoreWindow(GLFWwindow* handle)
{
    if (!ready()) return;
    (void)window_of(handle, "glfwRestoreWindow");
    soon(handle, Iconify{false});
}

void glfwShowWindow(GLFWwindow* handle)
{
    if (ready()) window_of(handle, "glfwShowWindow").attributes[GLFW_VISIBLE] = 1;
}

void glfwHideWindow(GLFWwindow* handle)
{
    if (ready()) window_of(handle, "glfwHideWindow").attributes[GLFW_VISIBLE] = 0;
}

void glfwFocusWindow(GLFWwindow* handle)
{
    if (!ready()) return;
    (void)window_of(handle, "glfwFocusWindow");
    soon(handle, Focus{true});
}

GLFWmonitor* glfwGetWindowMonitor(GLFWwindow* handle)
{
    if (ready()) (void)window_of(handle, "glfwGetWindowMonitor");
    return nullptr;
}

int glfwGetWindowAttrib(GLFWwindow* handle, int attribute)
{
    if (!ready()) return 0;
    GLFWwindow& window = window_of(handle, "glfwGetWindowAttrib");
    return is_known(window.attributes, attribute, "window attribute") ? window.attributes[attribute] : 0;
}

void glfwSetWindowAttrib(GLFWwindow* handle, int attribute, int value)
{
    if (!ready()) return;
    GLFWwindow& window = window_of(handle, "glfwSetWindowAttrib");
    for (const int known : changeable)
        if (attribute == known) {
            window.attributes[attribute] = static_cast<int>(value != 0);
            return;
        }
    report(GLFW_INVALID_ENUM, "Invalid window attribute " + std::to_string(attribute));
}

void glfwSetWindowUserPointer(GLFWwindow* handle, void* pointer)
{
    if (ready()) window_of(handle, "glfwSetWindowUserPointer").user_pointer = pointer;
}

void* glfwGetWindowUserPointer(GLFWwindow* handle)
{
    return ready() ? window_of(handle, "glfwGetWindowUserPointer").user_pointer : nullptr;
}
}
