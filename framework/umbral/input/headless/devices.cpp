#include <umbral/input/names.hpp>

#include "state.hpp"

// Mouse, keyboard and clipboard as a program asks for them, and the devices that are not there: monitors and joysticks.

namespace umbral::input::headless {
namespace {

/// What is told of a key or button: a sticky one counts as pressed once more.
int told(int& held)
{
    if (held != stuck) return held;
    held = GLFW_RELEASE;
    return GLFW_PRESS;
}

bool is_input_mode(int mode)
{
    for (const int known :
         {GLFW_CURSOR, GLFW_STICKY_KEYS, GLFW_STICKY_MOUSE_BUTTONS, GLFW_LOCK_KEY_MODS, GLFW_RAW_MOUSE_MOTION})
        if (mode == known) return true;
    report(GLFW_INVALID_ENUM, "Invalid input mode " + std::to_string(mode));
    return false;
}

template <std::size_t Count>
void release_stuck(std::array<int, Count>& all)
{
    for (int& held : all)
        if (held == stuck) held = GLFW_RELEASE;
}

void set_input_mode(GLFWwindow& window, int mode, int value)
{
    if (mode == GLFW_CURSOR && value != GLFW_CURSOR_NORMAL && value != GLFW_CURSOR_HIDDEN &&
        value != GLFW_CURSOR_DISABLED)
        return report(GLFW_INVALID_ENUM, "Invalid cursor mode " + std::to_string(value));
    if (mode == GLFW_RAW_MOUSE_MOTION)
        return report(GLFW_PLATFORM_ERROR, "Raw mouse motion is not supported on this system");
    window.input_modes[mode] = mode == GLFW_CURSOR ? value : static_cast<int>(value != 0);
    if (value == 0 && mode == GLFW_STICKY_KEYS) release_stuck(window.keys);
    if (value == 0 && mode == GLFW_STICKY_MOUSE_BUTTONS) release_stuck(window.buttons);
}

}
}

using namespace umbral::input::headless;

extern "C" {

int glfwGetKey(GLFWwindow* handle, int key)
{
    if (!ready()) return GLFW_RELEASE;
    GLFWwindow& window = window_of(handle, "glfwGetKey");
    if (key >= GLFW_KEY_SPACE && key <= GLFW_KEY_LAST) return told(window.keys.at(static_cast<std::size_t>(key)));
    report(GLFW_INVALID_ENUM, "Invalid key " + std::to_string(key));
    return GLFW_RELEASE;
}

int glfwGetMouseButton(GLFWwindow* handle, int button)
{
    if (!ready()) return GLFW_RELEASE;
    GLFWwindow& window = window_of(handle, "glfwGetMouseButton");
    if (button >= 0 && button <= GLFW_MOUSE_BUTTON_LAST)
        return told(window.buttons.at(static_cast<std::size_t>(button)));
    report(GLFW_INVALID_ENUM, "Invalid mouse button " + std::to_string(button));
    return GLFW_RELEASE;
}

void glfwGetCursorPos(GLFWwindow* handle, double* x, double* y)
{
    if (x != nullptr) *x = 0;
    if (y != nullptr) *y = 0;
    if (!ready()) return;
    const GLFWwindow& window = window_of(handle, "glfwGetCursorPos");
    if (x != nullptr) *x = window.cursor.x;
    if (y != nullptr) *y = window.cursor.y;
}

void glfwSetCursorPos(GLFWwindow* handle, double x, double y)
{
    if (!ready()) return;
    GLFWwindow& window = window_of(handle, "glfwSetCursorPos");
    if (!(std::abs(x) <= 1e300 && std::abs(y) <= 1e300)) return report(GLFW_INVALID_VALUE, "Invalid cursor position");
    if (window.attributes[GLFW_FOCUSED] != 0) window.cursor = {x, y};
}

int glfwGetInputMode(GLFWwindow* handle, int mode)
{
    if (!ready()) return 0;
    GLFWwindow& window = window_of(handle, "glfwGetInputMode");
    return is_input_mode(mode) ? window.input_modes[mode] : 0;
}

void glfwSetInputMode(GLFWwindow* handle, int mode, int value)
{
    if (!ready()) return;
    GLFWwindow& window = window_of(handle, "glfwSetInputMode");
    if (is_input_mode(mode)) set_input_mode(window, mode, value);
}

int glfwRawMouseMotionSupported()
{
    (void)ready();
    return GLFW_FALSE;
}

int glfwGetKeyScancode(int key)
{
    if (!ready()) return -1;
    if (key >= GLFW_KEY_SPACE && key <= GLFW_KEY_LAST) return key;
    report(GLFW_INVALID_ENUM, "Invalid key " + std::to_string(key));
    return -1;
}

const char* glfwGetKeyName(int key, int scancode)
{
    if (!ready()) return nullptr;
    // One character each, and a zero after it, for as long as the program lives.
    static constexpr auto names = [] {
        std::array<char, 256> text{};
        for (std::size_t i = 0; i < 128; ++i) text[2 * i] = static_cast<char>(i);
        return text;
    }();
    const char character = umbral::input::character_of(key == GLFW_KEY_UNKNOWN ? scancode : key, false);
    return character <= ' ' ? nullptr : &names.at(2 * static_cast<std::size_t>(character));
}

void glfwSetClipboardString(GLFWwindow*, const char* text)
{
    if (ready() && text != nullptr) state().clipboard = text;
}

const char* glfwGetClipboardString(GLFWwindow*)
{
    if (!ready()) return nullptr;
    if (!state().clipboard.empty()) return state().clipboard.c_str();
    report(GLFW_FORMAT_UNAVAILABLE, "The clipboard holds no text");
    return nullptr;
}

GLFWmonitor** glfwGetMonitors(int* count)
{
    if (count != nullptr) *count = 0;
    (void)ready();
    return nullptr;
}

GLFWmonitor* glfwGetPrimaryMonitor()
{
    (void)ready();
    return nullptr;
}

int glfwJoystickPresent(int)
{
    (void)ready();
    return GLFW_FALSE;
}

int glfwJoystickIsGamepad(int)
{
    (void)ready();
    return GLFW_FALSE;
}

int glfwVulkanSupported()
{
    (void)ready();
    return GLFW_FALSE;
}
}
