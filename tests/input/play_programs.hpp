#pragma once

#include <cstdio>
#include <interaction/event-loop/sessions.hpp>
#include <string>
#include <umbral/interaction/input_modes.hpp>
#include <vector>

/// What the two programs share that run event loops and read input in three modes, one in a real window and one
/// without: what they play, and the lines that they print.
namespace umbral::interaction {

/// What xdotool can do of the sessions that a loop is tried by: keys and motions, with an end to each press of a key,
/// and few of them.
inline std::vector<LoopSession> loop_sessions_for_hands(const NamedLoop& loop)
{
    const bool waits = loop.run == run_waiting_loop;
    std::vector<LoopSession> result;
    for (const auto& list : {waits ? needs() : motions(), endings(), waits ? refinements() : switches()})
        for (LoopSession session : list) {
            input::EventScript script;
            // A hidden window has no keyboard.
            bool playable = session.script.size() < 20 && !session.hides;
            for (const auto& [time, event] : session.script) {
                const auto* const key = std::get_if<input::Key>(&event);
                playable = playable && (key != nullptr || std::holds_alternative<input::CursorMove>(event));
                script.push_back({time, event});
                if (key != nullptr) script.push_back({time, input::Key{key->key, input::Key::Action::release}});
            }
            session.script = script;
            if (playable) result.push_back(session);
        }
    return result;
}

inline void print_rows(const NamedLoop& loop, const std::vector<LoopRow>& rows)
{
    std::printf("%s:", loop.name);
    for (const LoopRow& row : rows) std::printf(" %g/%g", double{row[0]}, double{row[1]});
    std::printf("\n");
}

inline constexpr const char* input_for_hands = R"(
0.1 move 40 30
0.15 press left          # before the first request
0.2 release left
0.5 move 60 35
0.6 move 70 45
0.6 press right
0.7 key A press
0.8 press left
0.9 release right
1.0 key A release
1.4 press middle         # while the program works
1.6 move -20 500
1.7 scroll 0 1
1.8 scroll 0 -1
1.9 move 90 80
1.9 release middle
2.0 release left
2.1 key B press
2.2 key B release
)";

inline void print_event(const char* mode, const std::optional<InputEvent>& event)
{
    if (!event) return void(std::printf("%s: none\n", mode));
    std::printf("%s: kind %d code %d change %g %g at %g %g buttons %u\n", mode, static_cast<int>(event->kind),
                event->code, event->change.x, event->change.y, event->after.cursor.x, event->after.cursor.y,
                event->after.buttons);
}

/// Reads the input of a window in all three modes. Swapping buffers is work during which nobody listens.
inline void read_in_three_modes(GLFWwindow* window)
{
    InputMemory memory;
    glfwSetWindowUserPointer(window, &memory);
    install_input(window);
    const auto sample = [&] {
        const MouseState state = sample_mouse(window);
        std::printf("sample: %g %g %u\n", state.cursor.x, state.cursor.y, state.buttons);
    };
    for (int i = 0; i < 4; ++i) glfwSwapBuffers(window);  // 0.25 s
    for (const InputKind kind : {InputKind::button_pressed, InputKind::key_pressed, InputKind::button_released}) {
        print_event("request", request_event(window, kind));
        sample();
    }
    for (int i = 0; i < 10; ++i) glfwSwapBuffers(window);
    for (const InputKind kind : {InputKind::cursor_moved, InputKind::scrolled, InputKind::button_released,
                                 InputKind::key_released, InputKind::button_pressed}) {
        print_event("request", request_event(window, kind));
        sample();
    }
    while (const auto event = next_event(window)) print_event("queue", event);
    print_event("queue", next_event(window));
}

}
