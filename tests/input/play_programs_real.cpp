// play-programs-real: the same programs as play-programs-headless in a window of the real GLFW, where xdotool does what
// the scripts say. The units' references are linked as they are; their calls that process events, swap buffers and ask
// for the time come by here first (--wrap), so that time is the script's: a poll takes 1/1024 s and a frame what the
// program says, and a wait ends with the next event.

#include "hands.hpp"
#include "play_programs.hpp"

// NOLINTBEGIN(bugprone-reserved-identifier): the linker's own names
extern "C" {
void __real_glfwPollEvents();
void __real_glfwWaitEvents();
void __real_glfwSwapBuffers(GLFWwindow* window);
double __real_glfwGetTime();
}

namespace {

using namespace umbral;
using namespace umbral::interaction;

/// What the wrapped functions know: GLFW gives them nothing.
struct Play {
    GLFWwindow* window = nullptr;  ///< null: nothing is played
    std::optional<input::Hands> hands;
    input::EventScript script;
    std::size_t next = 0;
    double now = 0;
    double frame_seconds = 1.0 / 64;
    std::function<void()> on_frame;
};

Play& play()
{
    static Play only;
    return only;
}

/// Has xdotool do what is due, and delivers what came of it.
void deliver_due()
{
    Play& now = play();
    for (; now.next < now.script.size() && now.script[now.next].time <= now.now; ++now.next)
        std::visit(*now.hands, now.script[now.next].event);
    double ignored = 0;
    glfwGetCursorPos(now.window, &ignored, &ignored);  // with the answer all events are there
    __real_glfwPollEvents();
}

void begin(const input::EventScript& script, double frame_seconds, std::function<void()> on_frame)
{
    Play& now = play();
    glfwSetWindowShouldClose(now.window, GLFW_FALSE);
    now.script = script;
    now.next = 0;
    now.now = 0;
    now.frame_seconds = frame_seconds;
    now.on_frame = std::move(on_frame);
    std::visit(*now.hands, input::Event(input::CursorMove{{0, 0}}));
    deliver_due();
}

}

extern "C" {

void __wrap_glfwPollEvents()
{
    if (play().window == nullptr) return __real_glfwPollEvents();
    play().now += 1.0 / 1024;
    deliver_due();
}

void __wrap_glfwWaitEvents()
{
    Play& now = play();
    if (now.window == nullptr) return __real_glfwWaitEvents();
    if (now.next == now.script.size()) return glfwSetWindowShouldClose(now.window, GLFW_TRUE);
    now.now = std::max(now.now, now.script[now.next].time);
    deliver_due();
}

void __wrap_glfwSwapBuffers(GLFWwindow* window)
{
    __real_glfwSwapBuffers(window);
    if (play().on_frame) play().on_frame();
    play().now += play().frame_seconds;
}

double __wrap_glfwGetTime() { return play().window == nullptr ? __real_glfwGetTime() : play().now; }
}
// NOLINTEND(bugprone-reserved-identifier)

int main()
try {
    GLFWwindow* const window = input::open_window(GLFW_OPENGL_API);
    glfwMakeContextCurrent(window);
    glfwSwapInterval(0);
    play().hands.emplace(window);
    play().window = window;
    for (const NamedLoop& loop : {waiting_loop, animated_loop, switching_loop})
        for (const LoopSession& session : loop_sessions_for_hands(loop)) {
            LoggedProgram program(session.flags, session.habits);
            begin(session.script, 1.0 / 64, [&] { program.shown(); });
            program.listen(window);
            if (session.closes) glfwSetWindowShouldClose(window, GLFW_TRUE);
            loop.run(window, program, program.flags);
            program.closing = glfwWindowShouldClose(window) == GLFW_TRUE;
            program.returned();
            print_rows(loop, program.rows);
            glfwSetWindowUserPointer(window, nullptr);
            glfwSetKeyCallback(window, nullptr);
            glfwSetCursorPosCallback(window, nullptr);
            glfwSetWindowIconifyCallback(window, nullptr);
            glfwSetWindowCloseCallback(window, nullptr);
            glfwSetFramebufferSizeCallback(window, nullptr);
            glfwSetWindowRefreshCallback(window, nullptr);
            // What the loop left undone, so that no key stays down.
            play().now = 1e9;
            deliver_due();
        }
    begin(input::parse_script(input_for_hands), 1.0 / 16, {});
    read_in_three_modes(window);
    return 0;
} catch (const std::exception& error) {
    (void)std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
