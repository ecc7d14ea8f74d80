// alternative: a class whose steps say whether to go on; the window's sides asked for one by one
#include <umbral/interaction/event_loop.hpp>

namespace umbral::interaction {

namespace {

enum class Motion { never, always, by_flag };

class Runner {
public:
    Runner(GLFWwindow* w, LoopProgram& p, LoopFlags& f, Motion m) : w_(w), p_(p), f_(f), m_(m) {}

    void operator()()
    {
        for (;;) {
            if (!frame()) return;
            if (!events()) return;
            if (moving() && visible()) p_.update();
        }
    }

private:
    bool go_on() const { return !(glfwWindowShouldClose(w_) || f_.finish); }
    bool moving() const { return m_ == Motion::always || (m_ == Motion::by_flag && f_.animate); }

    bool visible() const
    {
        int w = 0, h = 0;
        glfwGetFramebufferSize(w_, &w, nullptr);
        glfwGetFramebufferSize(w_, nullptr, &h);
        return w && h && !glfwGetWindowAttrib(w_, GLFW_ICONIFIED);
    }

    bool frame()
    {
        if (!go_on()) return false;
        if (visible() && f_.redraw) {
            f_.redraw = false;
            p_.draw();
            glfwSwapBuffers(w_);
        }
        return go_on();
    }

    bool events()
    {
        const bool busy = visible() ? moving() || f_.redraw : false;
        void (*process)() = busy ? glfwPollEvents : glfwWaitEvents;
        process();
        return go_on();
    }

    GLFWwindow* w_;
    LoopProgram& p_;
    LoopFlags& f_;
    Motion m_;
};

}

void run_waiting_loop(GLFWwindow* w, LoopProgram& p, LoopFlags& f) { Runner(w, p, f, Motion::never)(); }
void run_animated_loop(GLFWwindow* w, LoopProgram& p, LoopFlags& f) { Runner(w, p, f, Motion::always)(); }
void run_switching_loop(GLFWwindow* w, LoopProgram& p, LoopFlags& f) { Runner(w, p, f, Motion::by_flag)(); }

}
