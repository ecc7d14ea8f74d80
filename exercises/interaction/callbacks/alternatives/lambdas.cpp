// alternative: lambdas, a table of keys, and the press found by the motion before it
#include <cmath>
#include <umbral/interaction/callbacks.hpp>

namespace umbral::interaction {

void install_callbacks(GLFWwindow* window)
{
    static constexpr auto controls = [](GLFWwindow* w) { return static_cast<Controls*>(glfwGetWindowUserPointer(w)); };

    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
        Controls* c = controls(w);
        const bool dragging = c->drag != Drag::none;
        if (action == GLFW_RELEASE && dragging && button == c->drag_button) c->drag = Drag::none;
        if (action == GLFW_RELEASE || dragging || button > GLFW_MOUSE_BUTTON_RIGHT) return;
        const bool pan = button == GLFW_MOUSE_BUTTON_RIGHT || (mods & GLFW_MOD_SHIFT) == GLFW_MOD_SHIFT;
        c->drag = pan ? Drag::pan : Drag::orbit;
        c->drag_button = button;
        glfwGetCursorPos(w, &c->last_cursor.x, &c->last_cursor.y);
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        Controls* c = controls(w);
        const glm::dvec2 motion(x - c->last_cursor.x, c->last_cursor.y - y);
        c->last_cursor = glm::dvec2(x, y);
        switch (c->drag) {
            case Drag::orbit: c->commands->orbit(motion); break;
            case Drag::pan: c->commands->pan(motion); break;
            case Drag::none: break;
        }
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double y) {
        if (std::fabs(y) > 0) controls(w)->commands->zoom(std::exp(-y * std::log(1.1)));
    });
    controls(window)->previous_key =
        glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
            Controls* c = controls(w);
            const bool shortcut = mods & ~(GLFW_MOD_SHIFT | GLFW_MOD_CAPS_LOCK | GLFW_MOD_NUM_LOCK);
            const bool pressed = action == GLFW_PRESS;
            if (pressed && !shortcut) {
                switch (key) {
                    case GLFW_KEY_R: c->commands->reset(); break;
                    case GLFW_KEY_1: c->commands->view_mode(1); break;
                    case GLFW_KEY_2: c->commands->view_mode(2); break;
                    case GLFW_KEY_3: c->commands->view_mode(3); break;
                    default: break;
                }
            }
            if (c->previous_key) c->previous_key(w, key, scancode, action, mods);
            if (pressed && key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(w, 1);
        });
    static constexpr auto resized = [](GLFWwindow* w, int width, int height) {
        if (width == 0 || height == 0) return;
        controls(w)->commands->viewport(width, height, double(width) / double(height));
    };
    glfwSetFramebufferSizeCallback(window, resized);
    int size[2];
    glfwGetFramebufferSize(window, &size[0], &size[1]);
    resized(window, size[0], size[1]);
}

}
