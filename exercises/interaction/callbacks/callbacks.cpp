#include <umbral/interaction/callbacks.hpp>

namespace umbral::interaction {

void install_callbacks(GLFWwindow* window)
{
    // TODO: above this function, write one callback for each kind of event, with GLFW's signatures, as
    //     void on_scroll(GLFWwindow* window, double x_offset, double y_offset)
    // and register them here: glfwSetMouseButtonCallback, glfwSetCursorPosCallback, glfwSetScrollCallback,
    // glfwSetKeyCallback and glfwSetFramebufferSizeCallback. In each,
    // static_cast<Controls*>(glfwGetWindowUserPointer(window)) leads to the window's Controls. Then give the first
    // viewport. Delete the next line.
    (void)not_implemented<int>(window);
}

}
