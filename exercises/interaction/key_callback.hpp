#pragma once

#include <umbral/input/glfw.hpp>

namespace umbral::interaction {

/// The window's key callback, or null: to be called as GLFW would, for keys that no script can press. It stays.
inline GLFWkeyfun key_callback_of(GLFWwindow* window)
{
    const GLFWkeyfun callback = glfwSetKeyCallback(window, nullptr);
    glfwSetKeyCallback(window, callback);
    return callback;
}

}
