// play-programs-headless: the loops of interaction/event-loop and a reader by interaction/input-modes without a window.

#include "play_programs.hpp"

int main()
{
    using namespace umbral;
    using namespace umbral::interaction;
    for (const NamedLoop& loop : {waiting_loop, animated_loop, switching_loop})
        for (const LoopSession& session : loop_sessions_for_hands(loop)) print_rows(loop, play(loop, session).rows);
    const input::Headless session(input::parse_script(input_for_hands), {.frame_seconds = 1.0 / 16});
    glfwInit();
    GLFWwindow* const window = glfwCreateWindow(640, 480, "Umbral", nullptr, nullptr);
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    read_in_three_modes(window);
    return 0;
}
