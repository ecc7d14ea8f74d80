#pragma once

#include <array>
#include <sstream>
#include <string>
#include <string_view>
#include <umbral/core/student_error.hpp>
#include <umbral/input/script.hpp>
#include <vector>

#include "scripted_program.hpp"

/// What a loop did, as rows of numbers: what loops are judged by, without a screen and (in a test) with one.
namespace umbral::interaction {

/// What the program does by itself. Draws and updates are counted from 1; 0 is none of them.
struct Habits {
    int unfinished_draws = 0;  ///< so many draws, from the first one, set `redraw`
    int last_draw = 0;         ///< this draw ends all: it sets `finish`
    int waking_draw = 0;       ///< this draw sets `animate`
    int moves_every = 1;       ///< the updates whose number this divides set `redraw`; 0: none
    int resting_update = 0;    ///< this update clears `animate`
    int last_update = 0;       ///< this update ends all
    int hiding_draw = 0;       ///< this draw minimises the window, at once
    int hiding_update = 0;     ///< this update minimises the window, at once
    bool by_window = false;    ///< what ends all asks the window to close instead
    bool escape_ends = true;   ///< else Escape means nothing
};

/// First its code, then how many events the program had heard by then; of the flags that are left, which ones are set,
/// that of the window among them.
using LoopRow = std::array<float, 2>;

/// What can be left when a loop returns, in the order of a row's bits.
inline constexpr std::array left_names = {"finish", "redraw", "animate", "window asked to close",
                                          "swap interval changed"};
inline constexpr int first_left_code = 10;

/// What rows are called behind which their session stands: a number from 1 on. What is left has a code of its own for
/// each set of flags, so that reports say which ones they are.
inline std::string loop_row_names()
{
    std::string names =
        "1 draw: events heard, session\n2 frame shown: events heard, session\n"
        "3 update: events heard, session\n4 returned: events heard, session\n"
        "5 stopped: events heard, session\n";
    for (int left = 0; left < 1 << left_names.size(); ++left) {
        std::string flags;
        for (std::size_t i = 0; i < left_names.size(); ++i)
            if ((left >> i & 1) != 0) flags += (flags.empty() ? "" : " and ") + std::string(left_names[i]);
        names += std::to_string(first_left_code + left) + " left set (" + (flags.empty() ? "nothing" : flags) +
                 "): events heard, session\n";
    }
    return names;
}

class LoggedProgram final : public ScriptedProgram {
public:
    LoggedProgram(const LoopFlags& first, const Habits& habits) : ScriptedProgram(first), habits_(habits)
    {
        escape_ends = habits.escape_ends;
    }

    void draw() override
    {
        log(1);
        ++draws_;
        if (draws_ <= habits_.unfinished_draws) flags.redraw = true;
        if (draws_ == habits_.last_draw) end();
        if (draws_ == habits_.waking_draw) flags.animate = true;
        if (draws_ == habits_.hiding_draw) hide();
    }

    void update() override
    {
        log(3);
        ++updates_;
        if (habits_.moves_every > 0 && updates_ % habits_.moves_every == 0) flags.redraw = true;
        if (updates_ == habits_.resting_update) flags.animate = false;
        if (updates_ == habits_.last_update) end();
        if (updates_ == habits_.hiding_update) hide();
    }

    void shown() { log(2); }
    void returned(bool waits_as_before = true)
    {
        log(4);
        const int left = (flags.finish ? 1 : 0) + (flags.redraw ? 2 : 0) + (flags.animate ? 4 : 0) + (closing ? 8 : 0) +
                         (waits_as_before ? 0 : 16);
        rows.push_back({6, static_cast<float>(left)});
    }
    void stopped() { log(5); }

    std::vector<LoopRow> rows;

private:
    void log(int code) { rows.push_back({static_cast<float>(code), static_cast<float>(heard)}); }

    void end()
    {
        if (habits_.by_window)
            glfwSetWindowShouldClose(glfwGetCurrentContext(), GLFW_TRUE);
        else
            flags.finish = true;
    }

    // Some systems minimise a window while they are asked to, others when events are processed next: here, at once.
    static void hide()
    {
        glfwIconifyWindow(glfwGetCurrentContext());
        glfwPollEvents();
    }

    Habits habits_;
    int draws_ = 0;
    int updates_ = 0;
};

/// A program, and what happens to it.
struct LoopSession {
    input::EventScript script;
    LoopFlags flags{};
    Habits habits{};
    bool closes = false;  ///< the window has been asked to close before the loop begins
    bool hides = false;   ///< the window has been hidden before, which is not minimised
    double content_scale = 1;
    int swap_interval = 1;  ///< set by the program before the loop begins
};

struct LoopResult {
    std::vector<LoopRow> rows;
    input::Usage usage{};
    std::string stopped{};  ///< why the loop had to be stopped, if it would never have returned
};

inline LoopResult play(const NamedLoop& loop, const LoopSession& session)
{
    LoggedProgram program(session.flags, session.habits);
    const input::HeadlessSettings settings{.content_scale = glm::dvec2(session.content_scale),
                                           .patience_seconds = 0.1,
                                           .polls_after_closing = 20,
                                           .on_frame = [&] { program.shown(); }};
    try {
        const input::Usage usage =
            run_by(loop, program, session.script, settings, session.closes, session.hides, session.swap_interval);
        program.returned(program.waits_for_screen == (session.swap_interval != 0));
        return {program.rows, usage};
    } catch (const StudentError& error) {
        program.stopped();
        return {.rows = program.rows, .stopped = error.what()};
    }
}

/// What was done, for people: the call, what the program does by itself, and the script.
inline std::string told(const NamedLoop& loop, const LoopSession& session)
{
    std::string text = "// flags:";
    const auto say_if = [&](bool condition, const std::string& words) {
        if (condition) text += words;
    };
    const auto number = [](int value) { return std::to_string(value); };
    const Habits& habits = session.habits;
    say_if(session.flags.redraw, " redraw");
    say_if(session.flags.animate, " animate");
    say_if(session.flags.finish, " finish");
    say_if(session.closes, "\nglfwSetWindowShouldClose(window, GLFW_TRUE);");
    say_if(session.hides, "\nglfwHideWindow(window);");
    say_if(session.swap_interval == 0, "\nglfwSwapInterval(0);");
    say_if(!habits.escape_ends, "\n// Escape means nothing, X sets finish");
    say_if(habits.unfinished_draws > 0, "\n// the first " + number(habits.unfinished_draws) + " draws set redraw");
    const std::string ends = habits.by_window ? " asks the window to close" : " sets finish";
    say_if(habits.last_draw > 0, "\n// draw " + number(habits.last_draw) + ends);
    say_if(habits.waking_draw > 0, "\n// draw " + number(habits.waking_draw) + " sets animate");
    say_if(habits.moves_every != 1,
           "\n// of updates, " + (habits.moves_every == 0 ? "none" : "each " + number(habits.moves_every) + "th") +
               " sets redraw");
    say_if(habits.resting_update > 0, "\n// update " + number(habits.resting_update) + " clears animate");
    say_if(habits.last_update > 0, "\n// update " + number(habits.last_update) + ends);
    const std::string hides = " minimises the window, and calls glfwPollEvents so that it is at once";
    say_if(habits.hiding_draw > 0, "\n// draw " + number(habits.hiding_draw) + hides);
    say_if(habits.hiding_update > 0, "\n// update " + number(habits.hiding_update) + hides);
    if (session.content_scale != 1) {
        std::ostringstream scale;
        scale << session.content_scale;
        text += "\n// each screen coordinate has " + scale.str() + " pixels of the framebuffer";
    }
    return text + '\n' + loop.name + "(window, program, flags);\n" + input::to_text(session.script);
}

}
