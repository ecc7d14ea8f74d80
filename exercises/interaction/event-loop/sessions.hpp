#pragma once

#include <umbral/core/random.hpp>

#include "loop_log.hpp"

/// The sessions that loops are tried by: few events each, written by hand or drawn at random.
namespace umbral::interaction {

inline LoopSession session_of(const char* script, const LoopFlags& flags = {}, const Habits& habits = {})
{
    return {.script = input::parse_script(script), .flags = flags, .habits = habits};
}

inline constexpr LoopFlags nothing_to_draw{.redraw = false};
inline constexpr LoopFlags at_work{.animate = true};

/// Events that need a frame and events that do not; several at one moment need one frame together.
inline std::vector<LoopSession> needs()
{
    std::vector<LoopSession> all = {
        // Of what a loop did before nothing is known: the first one has nothing to draw.
        session_of("0.1 key B press\n0.2 resize 300 200\n0.3 key ESCAPE press\n", nothing_to_draw),
        session_of("0.1 key B press\n0.2 key R press\n0.3 key B press\n0.4 key R press\n0.5 key ESCAPE press\n"),
        session_of("0.1 move 10 10\n0.1 move 11 12\n0.1 key R press\n0.2 key B press\n0.3 refresh\n"
                   "0.4 key ESCAPE press\n"),
        // Long pauses, and a window that has lost the focus, which is seen all the same.
        session_of("2 key B press\n7.25 key R press\n8 focus off\n9 refresh\n9.5 focus on\n11 key ESCAPE press\n"),
        // `animate` means nothing to the first two loops.
        session_of("0.05 key A press\n0.1 key R press\n0.13 key A press\n0.2 key ESCAPE press\n"),
        // A hidden window is not minimised.
        session_of("0.1 key R press\n0.2 key B press\n0.3 refresh\n0.4 key ESCAPE press\n"),
        // Keys that mean something in other programs, and are held.
        session_of("0.02 key F5 press\n0.04 key SPACE press\n0.06 key ENTER press\n0.08 key P press\n"
                   "0.1 key F1 press\n0.12 key UP press\n0.14 key F11 press\n0.16 key B press\n"
                   "0.18 key ESCAPE press\n"),
    };
    all[all.size() - 2].hides = true;
    return all;
}

/// Nobody comes near for more than a minute: for loops that sleep.
inline std::vector<LoopSession> pauses()
{
    return {
        session_of("70 key B press\n140 key R press\n210 refresh\n275 key ESCAPE press\n"),
        session_of("65 key R press\n140 key B press\n140 key R press\n205 close\n", nothing_to_draw),
    };
}

/// A picture that gets better with each draw, until it is finished; in the second session events come in between.
inline std::vector<LoopSession> refinements()
{
    std::vector<LoopSession> all = {
        session_of("0.5 key R press\n0.7 key ESCAPE press\n", {}, {.unfinished_draws = 24}),
        session_of("0.02 key B press\n0.03 key R press\n0.045 key B press\n0.3 key ESCAPE press\n", {},
                   {.unfinished_draws = 6}),
        session_of("0.02 key ESCAPE press\n", {}, {.unfinished_draws = 9}),
        session_of("0.07 key ESCAPE press\n", {}, {.unfinished_draws = 3}),
    };
    all.back().swap_interval = 0;
    return all;
}

/// All ways to end: by flag or window, from a callback, a draw or an update, before the loop or with work left.
inline std::vector<LoopSession> endings()
{
    std::vector<LoopSession> all = {
        session_of("0.05 key R press\n0.1 close\n"),
        session_of("0.05 key R press\n0.1 key R press\n0.1 key Q press\n0.2 key R press\n"),
        session_of("0.1 key R press\n0.1 key ESCAPE press\n0.1 key R press\n0.2 key R press\n"),
        session_of("0.1 key R press\n0.2 key R press\n0.3 key R press\n0.4 key ESCAPE press\n", {}, {.last_draw = 2}),
        session_of("0.1 key R press\n", {}, {.unfinished_draws = 5, .last_draw = 3}),
        session_of("0.1 key R press\n", {.finish = true}),
        session_of("0.1 key R press\n"),
        session_of("0.1 key R press\n0.3 key ESCAPE press\n", {}, {.last_update = 3}),
        session_of("0.1 key R press\n0.2 key R press\n0.4 key ESCAPE press\n", {}, {.last_draw = 2, .by_window = true}),
        session_of("0.1 key R press\n", {}, {.unfinished_draws = 5, .last_draw = 3, .by_window = true}),
        session_of("0.1 key R press\n0.3 key ESCAPE press\n", {}, {.last_update = 3, .by_window = true}),
        session_of("0.1 key R press\n0.15 key ESCAPE press\n0.2 key R press\n0.3 key X press\n", {},
                   {.escape_ends = false}),
        session_of("0.2 key R press\n0.3 key ESCAPE press\n", at_work, {.last_update = 2, .by_window = true}),
    };
    all[6].closes = true;
    // The program need not wait for the screen.
    all[7].swap_interval = 0;
    return all;
}

/// Minimised windows: iconified, or without pixels in one direction or both. What they need waits until they are back.
/// Some are minimised by a draw or an update, in the middle of a round.
inline std::vector<LoopSession> minimised()
{
    std::vector<LoopSession> all = {
        session_of("0.1 iconify on\n0.2 key R press\n0.3 key R press\n0.4 iconify off\n0.5 key ESCAPE press\n"),
        session_of("0.1 resize 0 0\n0.2 key B press\n0.3 resize 240 240\n0.4 key ESCAPE press\n"),
        session_of("0.1 resize 0 240\n0.2 key R press\n0.3 resize 240 240\n0.4 resize 240 0\n0.5 key R press\n"
                   "0.6 resize 200 100\n0.7 key ESCAPE press\n"),
        session_of("0.1 iconify on\n0.2 key B press\n0.3 iconify off\n0.4 key B press\n0.5 key ESCAPE press\n"),
        session_of("0.02 iconify on\n0.1 key B press\n0.2 key B press\n0.3 iconify off\n0.4 key ESCAPE press\n", {},
                   {.unfinished_draws = 6}),
        session_of("0.1 iconify on\n70 key R press\n71 key B press\n140 key ESCAPE press\n"),
        // One pixel is to be seen.
        session_of("0.1 resize 1 240\n0.2 key R press\n0.3 resize 240 1\n0.4 key R press\n"
                   "0.45 resize 1 1\n0.5 key ESCAPE press\n"),
        session_of("0.1 key R press\n0.2 key B press\n0.3 iconify off\n0.35 key R press\n0.4 key ESCAPE press\n",
                   at_work, {.unfinished_draws = 9, .hiding_draw = 2}),
        session_of("0.1 key R press\n0.3 key R press\n0.4 iconify off\n0.5 key ESCAPE press\n", at_work,
                   {.hiding_update = 3}),
        session_of("0.05 key R press\n0.2 key B press\n0.3 iconify off\n0.4 key ESCAPE press\n", at_work,
                   {.unfinished_draws = 1, .moves_every = 0, .hiding_draw = 1}),
        // A window of one screen coordinate may have no pixel.
        session_of("0.1 resize 1 240\n0.2 key R press\n0.3 resize 240 240\n0.4 key ESCAPE press\n"),
    };
    all[1].content_scale = 2;
    all.back().content_scale = 0.25;
    return all;
}

/// Scenes that move: in each update, in some, in none; a user whose hand never rests.
inline std::vector<LoopSession> motions()
{
    std::vector<LoopSession> all = {
        session_of("0.1 key ESCAPE press\n", at_work),
        session_of("0.05 key B press\n0.1 key ESCAPE press\n", at_work, {.moves_every = 3}),
        session_of("0.01 key R press\n0.02 key ESCAPE press\n", at_work, {.moves_every = 0}),
        session_of("0.02 key B press\n0.04 key R press\n0.1 key ESCAPE press\n", {.redraw = false, .animate = true}),
        session_of("0.1 key ESCAPE press\n", at_work, {.unfinished_draws = 3, .moves_every = 2}),
    };
    LoopSession busy = session_of("0.15 key ESCAPE press\n", at_work);
    input::EventScript hand;
    for (int i = 1; i < 140; ++i) hand.push_back({0.001 * i, input::CursorMove{{i, 2 * i}}});
    busy.script.insert(busy.script.begin(), hand.begin(), hand.end());
    all.push_back(busy);
    return all;
}

/// Animations that a key, a draw or an update switches on and off.
inline std::vector<LoopSession> switches()
{
    return {
        session_of("0.2 key A press\n0.3 key A press\n0.5 key A press\n0.55 key ESCAPE press\n"),
        session_of("0.2 key A press\n0.4 key R press\n0.5 key A press\n0.9 key ESCAPE press\n", {},
                   {.resting_update = 4}),
        session_of("0.3 key R press\n0.6 key B press\n0.7 key ESCAPE press\n", {},
                   {.waking_draw = 2, .resting_update = 3}),
        session_of("0.1 key A press\n0.1 key A press\n0.2 key R press\n0.3 key ESCAPE press\n"),
        session_of("0.1 key A press\n0.1 key R press\n0.2 key A press\n0.2 key ESCAPE press\n", {}, {.moves_every = 2}),
        session_of("0.1 iconify on\n0.15 key A press\n0.3 key R press\n0.4 iconify off\n0.45 key A press\n"
                   "0.6 key ESCAPE press\n"),
    };
}

/// Some of everything. Every session ends, by a key or by the window.
inline LoopSession random_loop_session(Random& random)
{
    LoopSession session;
    session.flags = {.redraw = random.below(4) != 0, .animate = random.below(2) == 0};
    session.habits = {.unfinished_draws = static_cast<int>(random.below(2) * random.below(4)),
                      .last_draw = static_cast<int>(random.below(8) == 0 ? 3 + random.below(6) : 0),
                      .waking_draw = static_cast<int>(random.below(3)),
                      .moves_every = static_cast<int>(random.below(4)),
                      .resting_update = static_cast<int>(random.below(10)),
                      .last_update = static_cast<int>(random.below(8) == 0 ? 5 + random.below(9) : 0),
                      .hiding_draw = static_cast<int>(random.below(6) == 0 ? 1 + random.below(5) : 0),
                      .hiding_update = static_cast<int>(random.below(6) == 0 ? 1 + random.below(5) : 0),
                      .by_window = random.below(2) == 0,
                      .escape_ends = random.below(2) == 0};
    session.hides = random.below(4) == 0;
    constexpr std::array others = {GLFW_KEY_B, GLFW_KEY_F5, GLFW_KEY_SPACE, GLFW_KEY_ENTER, GLFW_KEY_P, GLFW_KEY_F1};
    const int other = others[random.below(static_cast<std::uint32_t>(others.size()))];
    const int idle_key = session.habits.escape_ends ? other : GLFW_KEY_ESCAPE;
    int milliseconds = 0;
    bool iconified = false;
    bool flat = false;
    bool focused = true;
    const auto happens = [&](const input::Event& event) {
        milliseconds += static_cast<int>(random.below(3) * random.below(30));
        session.script.push_back({1e-3 * milliseconds, event});
    };
    for (int i = 0; i < 14; ++i) {
        switch (random.below(10)) {
            case 0:
            case 1: happens(input::Key{GLFW_KEY_R}); break;
            case 2: happens(input::Key{GLFW_KEY_A}); break;
            case 3: happens(input::Key{idle_key}); break;
            case 4: happens(input::Refresh{}); break;
            case 5: happens(input::Iconify{iconified = !iconified}); break;
            case 6: happens(input::Resize{(flat = !flat) ? glm::ivec2(0) : glm::ivec2(200, 100 + i)}); break;
            case 7: happens(input::Focus{focused = !focused}); break;
            default: happens(input::CursorMove{{random.below(200), random.below(200)}});
        }
    }
    if (random.below(2) == 0)
        happens(input::Close{});
    else
        happens(input::Key{session.habits.escape_ends ? GLFW_KEY_ESCAPE : GLFW_KEY_X});
    return session;
}

}
