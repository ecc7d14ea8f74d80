#include "state.hpp"

#include <algorithm>

#include <cmath>

namespace umbral::input::headless {

State& state()
{
    static State only;
    return only;
}

bool ready()
{
    if (state().initialised) return true;
    report(GLFW_NOT_INITIALIZED, "The GLFW library is not initialized");
    return false;
}

void report(int code, const std::string& text)
{
    State& now = state();
    now.error = code;
    now.error_text = text;
    if (now.error_callback != nullptr) now.error_callback(code, text.c_str());
}

void give_up(const std::string& text) { throw StudentError(StudentError::Kind::misuse, text); }

bool exists(const GLFWwindow* window)
{
    return std::ranges::any_of(state().windows, [&](const auto& one) { return one.get() == window; });
}

GLFWwindow& window_of(GLFWwindow* handle, const char* function)
{
    if (handle == nullptr)
        give_up(std::string(function) + ": the window is NULL; pass the GLFWwindow* that your function was given");
    if (!exists(handle))
        give_up(std::string(function) + ": this is not a window that exists (it was destroyed, or never created)");
    return *handle;
}

void not_from_a_callback(const char* function)
{
    if (state().delivering)
        give_up(std::string(function) + " must not be called from a callback: GLFW's documentation forbids it");
}

glm::ivec2 framebuffer_size(const GLFWwindow& window)
{
    const glm::dvec2 pixels = glm::dvec2(window.size) * state().settings.content_scale;
    return {static_cast<int>(std::lround(pixels.x)), static_cast<int>(std::lround(pixels.y))};
}

int held_modifiers(const GLFWwindow& window)
{
    const auto held = [&](std::size_t left, std::size_t right, int bit) {
        return window.keys[left] == GLFW_PRESS || window.keys[right] == GLFW_PRESS ? bit : 0;
    };
    return held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT, GLFW_MOD_SHIFT) |
           held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL, GLFW_MOD_CONTROL) |
           held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT, GLFW_MOD_ALT) |
           held(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER, GLFW_MOD_SUPER);
}

}
