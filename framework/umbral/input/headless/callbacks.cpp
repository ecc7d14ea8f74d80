#include "state.hpp"

// Every setter of a callback returns the one before, or null.

namespace umbral::input::headless {
namespace {

using Callbacks = decltype(GLFWwindow::callbacks);

template <class Callback>
Callback set_callback(GLFWwindow* handle, Callback Callbacks::*held, Callback given, const char* function)
{
    return ready() ? exchange_callback(window_of(handle, function).callbacks.*held, given) : nullptr;
}

}
}

using namespace umbral::input::headless;

extern "C" {

GLFWwindowposfun glfwSetWindowPosCallback(GLFWwindow* window, GLFWwindowposfun callback)
{
    return set_callback(window, &Callbacks::position, callback, "glfwSetWindowPosCallback");
}

GLFWwindowsizefun glfwSetWindowSizeCallback(GLFWwindow* window, GLFWwindowsizefun callback)
{
    return set_callback(window, &Callbacks::size, callback, "glfwSetWindowSizeCallback");
}

GLFWwindowclosefun glfwSetWindowCloseCallback(GLFWwindow* window, GLFWwindowclosefun callback)
{
    return set_callback(window, &Callbacks::close, callback, "glfwSetWindowCloseCallback");
}

GLFWwindowrefreshfun glfwSetWindowRefreshCallback(GLFWwindow* window, GLFWwindowrefreshfun callback)
{
    return set_callback(window, &Callbacks::refresh, callback, "glfwSetWindowRefreshCallback");
}

GLFWwindowfocusfun glfwSetWindowFocusCallback(GLFWwindow* window, GLFWwindowfocusfun callback)
{
    return set_callback(window, &Callbacks::focus, callback, "glfwSetWindowFocusCallback");
}

GLFWwindowiconifyfun glfwSetWindowIconifyCallback(GLFWwindow* window, GLFWwindowiconifyfun callback)
{
    return set_callback(window, &Callbacks::iconify, callback, "glfwSetWindowIconifyCallback");
}

GLFWwindowmaximizefun glfwSetWindowMaximizeCallback(GLFWwindow* window, GLFWwindowmaximizefun callback)
{
    return set_callback(window, &Callbacks::maximize, callback, "glfwSetWindowMaximizeCallback");
}

GLFWframebuffersizefun glfwSetFramebufferSizeCallback(GLFWwindow* window, GLFWframebuffersizefun callback)
{
    return set_callback(window, &Callbacks::framebuffer_size, callback, "glfwSetFramebufferSizeCallback");
}

GLFWwindowcontentscalefun glfwSetWindowContentScaleCallback(GLFWwindow* window, GLFWwindowcontentscalefun callback)
{
    return set_callback(window, &Callbacks::content_scale, callback, "glfwSetWindowContentScaleCallback");
}

GLFWkeyfun glfwSetKeyCallback(GLFWwindow* window, GLFWkeyfun callback)
{
    return set_callback(window, &Callbacks::key, callback, "glfwSetKeyCallback");
}

GLFWcharfun glfwSetCharCallback(GLFWwindow* window, GLFWcharfun callback)
{
    return set_callback(window, &Callbacks::character, callback, "glfwSetCharCallback");
}

GLFWcharmodsfun glfwSetCharModsCallback(GLFWwindow* window, GLFWcharmodsfun callback)
{
    return set_callback(window, &Callbacks::character_mods, callback, "glfwSetCharModsCallback");
}

GLFWmousebuttonfun glfwSetMouseButtonCallback(GLFWwindow* window, GLFWmousebuttonfun callback)
{
    return set_callback(window, &Callbacks::mouse_button, callback, "glfwSetMouseButtonCallback");
}

GLFWcursorposfun glfwSetCursorPosCallback(GLFWwindow* window, GLFWcursorposfun callback)
{
    return set_callback(window, &Callbacks::cursor_position, callback, "glfwSetCursorPosCallback");
}

GLFWcursorenterfun glfwSetCursorEnterCallback(GLFWwindow* window, GLFWcursorenterfun callback)
{
    return set_callback(window, &Callbacks::cursor_enter, callback, "glfwSetCursorEnterCallback");
}

GLFWscrollfun glfwSetScrollCallback(GLFWwindow* window, GLFWscrollfun callback)
{
    return set_callback(window, &Callbacks::scroll, callback, "glfwSetScrollCallback");
}

GLFWdropfun glfwSetDropCallback(GLFWwindow* window, GLFWdropfun callback)
{
    return set_callback(window, &Callbacks::drop, callback, "glfwSetDropCallback");
}

GLFWmonitorfun glfwSetMonitorCallback(GLFWmonitorfun callback)
{
    return ready() ? exchange_callback(state().monitor_callback, callback) : nullptr;
}

GLFWjoystickfun glfwSetJoystickCallback(GLFWjoystickfun callback)
{
    return ready() ? exchange_callback(state().joystick_callback, callback) : nullptr;
}
}
