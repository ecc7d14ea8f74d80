#include <cmath>

#include "state.hpp"

// Time, and what of a context needs no OpenGL: which one is current, and when frames are shown.

using namespace umbral::input::headless;

extern "C" {

double glfwGetTime() { return ready() ? state().now + state().time_offset : 0; }

void glfwSetTime(double time)
{
    if (!ready()) return;
    if (!(time >= 0 && time <= 18446744073.0))
        return report(GLFW_INVALID_VALUE, "Invalid time " + std::to_string(time));
    state().time_offset = time - state().now;
}

uint64_t glfwGetTimerFrequency() { return ready() ? 1'000'000'000 : 0; }

uint64_t glfwGetTimerValue() { return ready() ? static_cast<uint64_t>(std::llround(state().now * 1e9)) : 0; }

void glfwMakeContextCurrent(GLFWwindow* handle)
{
    if (!ready()) return;
    if (handle != nullptr && window_of(handle, "glfwMakeContextCurrent").attributes[GLFW_CLIENT_API] == GLFW_NO_API)
        return report(GLFW_NO_WINDOW_CONTEXT,
                      "Cannot make current with a window that has no OpenGL or OpenGL ES context");
    state().current = handle;
}

GLFWwindow* glfwGetCurrentContext() { return ready() ? state().current : nullptr; }

void glfwSwapInterval(int interval)
{
    if (!ready()) return;
    if (state().current == nullptr)
        return report(GLFW_NO_CURRENT_CONTEXT,
                      "Cannot set swap interval without a current OpenGL or OpenGL ES context");
    state().swap_interval = interval;
}

void glfwSwapBuffers(GLFWwindow* handle)
{
    if (!ready()) return;
    State& now = state();
    if (window_of(handle, "glfwSwapBuffers").attributes[GLFW_CLIENT_API] == GLFW_NO_API)
        return report(GLFW_NO_WINDOW_CONTEXT,
                      "Cannot swap buffers of a window that has no OpenGL or OpenGL ES context");
    now.usage.frames.push_back(now.now);
    if (now.settings.on_frame) now.settings.on_frame();
    if (now.swap_interval != 0) now.now += now.settings.frame_seconds;
}
}
