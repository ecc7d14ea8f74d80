// Based on: the course's event handlers (funciones gestoras de eventos) for GLFW; its drags count from the press, these
// from the last event.

#include <umbral/interaction/callbacks.hpp>

#include <cmath>

namespace umbral::interaction {
namespace {

Controls& controls_of(GLFWwindow* window) { return *static_cast<Controls*>(glfwGetWindowUserPointer(window)); }

glm::dvec2 cursor_of(GLFWwindow* window)
{
    glm::dvec2 cursor(0);
    glfwGetCursorPos(window, &cursor.x, &cursor.y);
    return cursor;
}

Drag drag_begun_by(int button, int mods)
{
    if (button == GLFW_MOUSE_BUTTON_LEFT) return (mods & GLFW_MOD_SHIFT) != 0 ? Drag::pan : Drag::orbit;
    return button == GLFW_MOUSE_BUTTON_RIGHT ? Drag::pan : Drag::none;
}

void on_mouse_button(GLFWwindow* window, int button, int action, int mods)
{
    Controls& controls = controls_of(window);
    if (action == GLFW_RELEASE) {
        if (button == controls.drag_button) controls.drag = Drag::none;
    } else if (controls.drag == Drag::none) {
        // The place of the press is asked for: the last motion may be long ago.
        controls.drag = drag_begun_by(button, mods);
        controls.drag_button = button;
        controls.last_cursor = cursor_of(window);
    }
}

void on_cursor_position(GLFWwindow* window, double x, double y)
{
    Controls& controls = controls_of(window);
    if (controls.drag == Drag::none) return;
    const glm::dvec2 motion = glm::dvec2(x, y) - controls.last_cursor;
    controls.last_cursor = {x, y};
    const glm::dvec2 upwards(motion.x, -motion.y);
    if (controls.drag == Drag::orbit)
        controls.commands->orbit(upwards);
    else
        controls.commands->pan(upwards);
}

void on_scroll(GLFWwindow* window, double, double steps)
{
    if (steps != 0) controls_of(window).commands->zoom(std::pow(1.1, -steps));
}

void on_key_press(GLFWwindow* window, Commands& commands, int key, int mods)
{
    if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(window, GLFW_TRUE);
    // With one of these the key means something else, such as a shortcut of the desktop.
    if ((mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0) return;
    if (key == GLFW_KEY_R) commands.reset();
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_3) commands.view_mode(key - GLFW_KEY_0);
}

void on_key(GLFWwindow* window, int key, int scancode, int action, int mods)
{
    const Controls& controls = controls_of(window);
    if (action == GLFW_PRESS) on_key_press(window, *controls.commands, key, mods);
    if (controls.previous_key != nullptr) controls.previous_key(window, key, scancode, action, mods);
}

void on_framebuffer_size(GLFWwindow* window, int width, int height)
{
    if (width > 0 && height > 0)
        controls_of(window).commands->viewport(width, height, static_cast<double>(width) / height);
}

}

void install_callbacks(GLFWwindow* window)
{
    glfwSetMouseButtonCallback(window, on_mouse_button);
    glfwSetCursorPosCallback(window, on_cursor_position);
    glfwSetScrollCallback(window, on_scroll);
    controls_of(window).previous_key = glfwSetKeyCallback(window, on_key);
    glfwSetFramebufferSizeCallback(window, on_framebuffer_size);

    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    on_framebuffer_size(window, width, height);
}

}
