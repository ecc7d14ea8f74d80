#include <umbral/interaction/event_loop.hpp>

namespace umbral::interaction {

void run_waiting_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    // TODO: until the loop is over: draw and show a frame if one is needed and the window is seen, then process events
    // with glfwPollEvents or glfwWaitEvents. Delete the next line.
    (void)not_implemented<int>(window, program, flags);
}

void run_animated_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    // TODO: the same, with an update in each round while the window is seen. Delete the next line.
    (void)not_implemented<int>(window, program, flags);
}

void run_switching_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    // TODO: either of the two, as flags.animate says at the moment. Delete the next line.
    (void)not_implemented<int>(window, program, flags);
}

}
