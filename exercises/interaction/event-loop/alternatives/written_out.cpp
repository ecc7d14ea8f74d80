// alternative: each loop written out, as the course prints them, with the flag cleared before the draw
#include <umbral/interaction/event_loop.hpp>

namespace umbral::interaction {

static bool has_pixels(GLFWwindow* window)
{
    if (glfwGetWindowAttrib(window, GLFW_ICONIFIED)) return false;
    int size[2];
    glfwGetFramebufferSize(window, size, size + 1);
    return size[0] * size[1] != 0;
}

static void show_frame(GLFWwindow* window, LoopProgram& program, bool& redraw)
{
    redraw = false;
    program.draw();
    glfwSwapBuffers(window);
}

void run_waiting_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    bool done = flags.finish || glfwWindowShouldClose(window);
    while (!done) {
        if (flags.redraw && has_pixels(window)) {
            show_frame(window, program, flags.redraw);
            if (flags.finish || glfwWindowShouldClose(window)) break;
        }
        if (flags.redraw && has_pixels(window)) {
            glfwPollEvents();
        } else {
            glfwWaitEvents();
        }
        done = flags.finish || glfwWindowShouldClose(window);
    }
}

void run_animated_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    bool done = flags.finish || glfwWindowShouldClose(window);
    while (!done) {
        if (flags.redraw && has_pixels(window)) {
            show_frame(window, program, flags.redraw);
            if (flags.finish || glfwWindowShouldClose(window)) break;
        }
        if (has_pixels(window)) {
            glfwPollEvents();
        } else {
            glfwWaitEvents();
        }
        done = flags.finish || glfwWindowShouldClose(window);
        if (!done && has_pixels(window)) {
            program.update();
            done = flags.finish || glfwWindowShouldClose(window);
        }
    }
}

void run_switching_loop(GLFWwindow* window, LoopProgram& program, LoopFlags& flags)
{
    bool done = flags.finish || glfwWindowShouldClose(window);
    while (!done) {
        if (flags.redraw && has_pixels(window)) {
            show_frame(window, program, flags.redraw);
            if (flags.finish || glfwWindowShouldClose(window)) break;
        }
        if ((flags.animate || flags.redraw) && has_pixels(window)) {
            glfwPollEvents();
        } else {
            glfwWaitEvents();
        }
        done = flags.finish || glfwWindowShouldClose(window);
        if (flags.animate && !done && has_pixels(window)) {
            program.update();
            done = flags.finish || glfwWindowShouldClose(window);
        }
    }
}

}
