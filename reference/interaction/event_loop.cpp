// Based on: the course's three loops (bucle de gestión de eventos: básico, con animaciones, genérico), with what they
// lose put right; and the documentation of GLFW 3.3, "Input guide: event processing" and "Window guide: iconification".

#include <umbral/interaction/event_loop.hpp>

namespace umbral::interaction {
namespace {

bool is_over(GLFWwindow* window, const LoopFlags& flags)
{
    return flags.finish || glfwWindowShouldClose(window) == GLFW_TRUE;
}

/// X11 and macOS keep the size of a minimised window and say that it is iconified; Windows makes it 0 x 0.
bool is_seen(GLFWwindow* window)
{
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    return width > 0 && height > 0 && glfwGetWindowAttrib(window, GLFW_ICONIFIED) == GLFW_FALSE;
}

void draw_if_needed(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    if (!flags.redraw || !is_seen(window)) return;
    // Cleared first: what draw() asks for is for the next frame.
    flags.redraw = false;
    program.draw();
    glfwSwapBuffers(window);
}

/// `is_moving` says at any time whether the scene moves by itself.
template <class IsMoving>
void run(GLFWwindow* window, LoopProgram& program, LoopFlags& flags, IsMoving is_moving)
{
    while (!is_over(window, flags)) {
        draw_if_needed(window, program, flags);
        if (is_over(window, flags)) return;

        if (is_seen(window) && (flags.redraw || is_moving()))
            glfwPollEvents();
        else
            glfwWaitEvents();

        if (!is_over(window, flags) && is_seen(window) && is_moving()) program.update();
    }
}

}

void run_waiting_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    run(window, program, flags, [] { return false; });
}

void run_animated_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    run(window, program, flags, [] { return true; });
}

void run_switching_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    run(window, program, flags, [&] { return flags.animate; });
}

}
