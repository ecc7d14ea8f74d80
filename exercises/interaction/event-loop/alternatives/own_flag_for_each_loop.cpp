// alternative: one loop that reads a flag by reference, which two of the functions keep to themselves
#include <umbral/interaction/event_loop.hpp>
#include <utility>

namespace umbral::interaction {

static void loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags, const bool& animated)
{
    auto over = [&] { return glfwWindowShouldClose(window) == GLFW_TRUE || flags.finish; };
    auto minimised = [&] {
        int width, height;
        glfwGetFramebufferSize(window, &width, &height);
        return glfwGetWindowAttrib(window, GLFW_ICONIFIED) == GLFW_TRUE || width == 0 || height == 0;
    };
    while (not over()) {
        if (not minimised() and std::exchange(flags.redraw, false)) {
            program.draw();
            glfwSwapBuffers(window);
            if (over()) break;
        }
        if (minimised() or not(animated or flags.redraw))
            glfwWaitEvents();
        else
            glfwPollEvents();
        if (over() or minimised() or not animated) continue;
        program.update();
    }
}

void run_waiting_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    const bool never = false;
    loop(window, program, flags, never);
}

void run_animated_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    const bool always = true;
    loop(window, program, flags, always);
}

void run_switching_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    loop(window, program, flags, flags.animate);
}

}
