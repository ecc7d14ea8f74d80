// alternative: asks GLFW for the framebuffer's size and whether the drag's button is still down, instead of remembering
#include <cmath>
#include <umbral/interaction/callbacks.hpp>

namespace umbral::interaction {
namespace {

struct Window {
    GLFWwindow* handle;
    Controls& controls;
    Commands& commands;

    explicit Window(GLFWwindow* window)
        : handle(window),
          controls(*reinterpret_cast<Controls*>(glfwGetWindowUserPointer(window))),
          commands(*controls.commands)
    {
    }

    bool dragging() const
    {
        return controls.drag != Drag::none && glfwGetMouseButton(handle, controls.drag_button) == GLFW_PRESS;
    }

    void tell_viewport() const
    {
        int width = 0, height = 0;
        glfwGetFramebufferSize(handle, &width, &height);
        if (width * height > 0) commands.viewport(width, height, width / static_cast<double>(height));
    }
};

void button_changed(GLFWwindow* handle, int button, int action, int mods)
{
    const Window window(handle);
    if (action == GLFW_RELEASE && button == window.controls.drag_button) window.controls.drag = Drag::none;
    if (action != GLFW_PRESS || window.controls.drag != Drag::none) return;
    if (button == GLFW_MOUSE_BUTTON_RIGHT || (button == GLFW_MOUSE_BUTTON_LEFT && (mods & GLFW_MOD_SHIFT)))
        window.controls.drag = Drag::pan;
    else if (button == GLFW_MOUSE_BUTTON_LEFT)
        window.controls.drag = Drag::orbit;
    window.controls.drag_button = button;
    double x, y;
    glfwGetCursorPos(handle, &x, &y);
    window.controls.last_cursor = {x, y};
}

void pointer_moved(GLFWwindow* handle, double x, double y)
{
    const Window window(handle);
    if (!window.dragging()) return;
    const glm::dvec2 motion = (glm::dvec2(x, y) - window.controls.last_cursor) * glm::dvec2(1, -1);
    window.controls.last_cursor += motion * glm::dvec2(1, -1);
    window.controls.drag == Drag::orbit ? window.commands.orbit(motion) : window.commands.pan(motion);
}

void wheel_turned(GLFWwindow* handle, double, double y)
{
    const double factor = std::pow(1 / 1.1, y);
    if (factor != 1) Window(handle).commands.zoom(factor);
}

void key_pressed(const Window& window, int key, int mods)
{
    if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(window.handle, GLFW_TRUE);
    if (mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) return;
    if (key == GLFW_KEY_R) window.commands.reset();
    if (key == GLFW_KEY_1) window.commands.view_mode(1);
    if (key == GLFW_KEY_2) window.commands.view_mode(2);
    if (key == GLFW_KEY_3) window.commands.view_mode(3);
}

void key_changed(GLFWwindow* handle, int key, int scancode, int action, int mods)
{
    const Window window(handle);
    if (action == GLFW_PRESS) key_pressed(window, key, mods);
    if (window.controls.previous_key) window.controls.previous_key(handle, key, scancode, action, mods);
}

void size_changed(GLFWwindow* handle, int, int) { Window(handle).tell_viewport(); }

}

void install_callbacks(GLFWwindow* handle)
{
    const Window window(handle);
    window.controls.previous_key = glfwSetKeyCallback(handle, key_changed);
    glfwSetMouseButtonCallback(handle, button_changed);
    glfwSetCursorPosCallback(handle, pointer_moved);
    glfwSetScrollCallback(handle, wheel_turned);
    glfwSetFramebufferSizeCallback(handle, size_changed);
    window.tell_viewport();
}

}
