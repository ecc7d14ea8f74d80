#include "state.hpp"

// Beginning, end, version and errors.

using namespace umbral::input::headless;

extern "C" {

int glfwInit()
{
    State& now = state();
    if (!now.initialised) now.hints = default_hints();
    now.initialised = true;
    return GLFW_TRUE;
}

void glfwTerminate()
{
    State& now = state();
    if (!now.initialised) return;
    not_from_a_callback("glfwTerminate");
    now.windows.clear();
    now.current = nullptr;
    now.pending.clear();
    now.monitor_callback = nullptr;
    now.joystick_callback = nullptr;
    now.initialised = false;
}

void glfwInitHint(int hint, int)
{
    if (hint != GLFW_JOYSTICK_HAT_BUTTONS && hint != GLFW_COCOA_CHDIR_RESOURCES && hint != GLFW_COCOA_MENUBAR)
        report(GLFW_INVALID_ENUM, "Invalid init hint " + std::to_string(hint));
}

void glfwGetVersion(int* major, int* minor, int* revision)
{
    if (major != nullptr) *major = GLFW_VERSION_MAJOR;
    if (minor != nullptr) *minor = GLFW_VERSION_MINOR;
    if (revision != nullptr) *revision = GLFW_VERSION_REVISION;
}

const char* glfwGetVersionString() { return "3.3 headless (Umbral)"; }

int glfwGetError(const char** description)
{
    State& now = state();
    const int code = now.error;
    now.told_error_text = now.error_text;
    if (description != nullptr) *description = code == GLFW_NO_ERROR ? nullptr : now.told_error_text.c_str();
    now.error = GLFW_NO_ERROR;
    return code;
}

GLFWerrorfun glfwSetErrorCallback(GLFWerrorfun callback) { return exchange_callback(state().error_callback, callback); }
}
