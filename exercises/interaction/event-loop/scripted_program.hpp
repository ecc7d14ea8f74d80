#pragma once

#include <glm/glm.hpp>
#include <umbral/input/headless.hpp>
#include <umbral/interaction/event_loop.hpp>

/// A program that is run by a loop while an event script is played to its window.
namespace umbral::interaction {

/// Its callbacks change the flags: R and each motion of the pointer set `redraw`, and so do new sizes and damaged
/// contents of the window; A turns `animate` over, X sets `finish`, and so does Escape if it is to, and Q asks the
/// window to close.
class ScriptedProgram : public LoopProgram {
public:
    explicit ScriptedProgram(const LoopFlags& first) : flags(first) {}

    LoopFlags flags;
    bool escape_ends = true;
    bool closing = false;           ///< when the loop had returned, the window was asked to close
    bool waits_for_screen = false;  ///< glfwSwapBuffers did so when the loop had returned
    int heard = 0;                  ///< events so far
    int needs = 0;                  ///< those that set `redraw`
    glm::dvec2 pointer{0};

    /// Registers the callbacks; the program must live as long as the window.
    void listen(GLFWwindow* window)
    {
        glfwSetWindowUserPointer(window, this);
        glfwGetCursorPos(window, &pointer.x, &pointer.y);
        glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int, int action, int) {
            if (action != GLFW_RELEASE) of(from).press(from, key);
        });
        glfwSetCursorPosCallback(window, [](GLFWwindow* from, double x, double y) {
            of(from).pointer = {x, y};
            of(from).damage();
        });
        glfwSetFramebufferSizeCallback(window, [](GLFWwindow* from, int, int) { of(from).damage(); });
        glfwSetWindowRefreshCallback(window, [](GLFWwindow* from) { of(from).damage(); });
        glfwSetWindowIconifyCallback(window, [](GLFWwindow* from, int) { of(from).hear(); });
        glfwSetWindowCloseCallback(window, [](GLFWwindow* from) { of(from).hear(); });
    }

protected:
    /// An event has come, and changed no flag yet.
    virtual void hear() { ++heard; }

private:
    static ScriptedProgram& of(GLFWwindow* window)
    {
        return *static_cast<ScriptedProgram*>(glfwGetWindowUserPointer(window));
    }

    void damage()
    {
        hear();
        need();
    }

    void need()
    {
        ++needs;
        flags.redraw = true;
    }

    void press(GLFWwindow* window, int key)
    {
        hear();
        if (key == GLFW_KEY_R) need();
        if (key == GLFW_KEY_A) flags.animate = !flags.animate;
        if (key == GLFW_KEY_X || (key == GLFW_KEY_ESCAPE && escape_ends)) flags.finish = true;
        if (key == GLFW_KEY_Q) glfwSetWindowShouldClose(window, GLFW_TRUE);
    }
};

/// One of the unit's three functions, and its name.
struct NamedLoop {
    const char* name;
    void (*run)(GLFWwindow*, LoopProgram&, LoopFlags&);
};
inline constexpr NamedLoop waiting_loop{"run_waiting_loop", run_waiting_loop};
inline constexpr NamedLoop animated_loop{"run_animated_loop", run_animated_loop};
inline constexpr NamedLoop switching_loop{"run_switching_loop", run_switching_loop};

/// Runs a program by a loop until the loop returns, in a window in which a frame takes 1/64 s and a poll 1/1024 s.
/// `closes`: the window has been asked to close before; `hides`: glfwHideWindow has been called; `interval`: of frames,
/// of which those take no time where it is 0. Tells how often the loop polled and waited.
inline input::Usage run_by(const NamedLoop& loop, ScriptedProgram& program, const input::EventScript& script,
                           const input::HeadlessSettings& settings = {}, bool closes = false, bool hides = false,
                           int interval = 1)
{
    bool is_running = true;
    input::HeadlessSettings watched = settings;
    watched.on_frame = [&] {
        if (is_running && settings.on_frame) settings.on_frame();
    };
    const input::Headless session(script, watched);
    glfwInit();
    GLFWwindow* const window = glfwCreateWindow(240, 240, "Umbral", nullptr, nullptr);
    glfwMakeContextCurrent(window);
    glfwSwapInterval(interval);
    program.listen(window);
    if (closes) glfwSetWindowShouldClose(window, GLFW_TRUE);
    if (hides) glfwHideWindow(window);
    loop.run(window, program, program.flags);
    program.closing = glfwWindowShouldClose(window) == GLFW_TRUE;
    is_running = false;
    const input::Usage usage = session.usage();
    // GLFW does not tell the interval; how long a frame takes does.
    const double before = glfwGetTime();
    glfwSwapBuffers(window);
    program.waits_for_screen = glfwGetTime() > before;
    return usage;
}

}
