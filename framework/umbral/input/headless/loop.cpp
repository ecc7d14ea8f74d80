#include <algorithm>

#include "state.hpp"

// glfwPollEvents and glfwWaitEvents…: the only places where callbacks run and where the script goes on.

namespace umbral::input::headless {
namespace {

/// While one of these lives, callbacks may be running.
class Delivering {
public:
    Delivering() { state().delivering = true; }
    ~Delivering() { state().delivering = false; }
    Delivering(const Delivering&) = delete;
    Delivering& operator=(const Delivering&) = delete;
};

bool script_is_over() { return state().next_event == state().script.size(); }

/// Is there something to deliver at this moment?
bool something_waits()
{
    return !state().pending.empty() || (!script_is_over() && state().script[state().next_event].time <= state().now);
}

/// The user's events go to the window that was made first.
void deliver_to_window(const Event& event)
{
    if (!state().windows.empty()) deliver(*state().windows.front(), event);
}

/// Everything that is due, in order. What callbacks cause themselves comes with the next call, as it does with a window
/// system.
void deliver_due()
{
    State& now = state();
    const Delivering delivering;
    now.woken = false;
    for (std::size_t count = now.pending.size(); count > 0; --count) {
        const OwnEvent own = now.pending.front();
        now.pending.pop_front();
        deliver(*own.window, own.event);
    }
    while (!script_is_over() && now.script[now.next_event].time <= now.now)
        deliver_to_window(now.script[now.next_event++].event);
}

void ask_to_close()
{
    state().asked_to_close = true;
    const Delivering delivering;
    deliver_to_window(Close{});
}

double last_event_time() { return state().script.empty() ? 0 : state().script.back().time; }

/// Where a program that polls is led out, once the script is over.
void end_polling()
{
    State& now = state();
    if (!now.asked_to_close) {
        if (now.now > last_event_time() + now.settings.patience_seconds) ask_to_close();
        return;
    }
    if (++now.polls_after_closing > now.settings.polls_after_closing)
        give_up(
            "glfwPollEvents: the window was asked to close long ago, but the loop goes on; does it look at "
            "glfwWindowShouldClose?");
}

void poll()
{
    State& now = state();
    now.now += now.settings.poll_seconds;
    deliver_due();
    if (script_is_over() && now.pending.empty()) end_polling();
}

void wait()
{
    State& now = state();
    if (!something_waits() && !now.woken) {
        if (script_is_over()) {
            if (now.asked_to_close)
                give_up(
                    "glfwWaitEvents: would wait for ever: the user has done everything and asked the window to close; "
                    "does the loop look at "
                    "glfwWindowShouldClose?");
            return ask_to_close();
        }
        now.now = now.script[now.next_event].time;
    }
    deliver_due();
}

void wait_until(double limit)
{
    State& now = state();
    if (!something_waits() && !now.woken)
        now.now = script_is_over() ? limit : std::min(limit, now.script[now.next_event].time);
    deliver_due();
    if (script_is_over() && now.pending.empty()) end_polling();
}

}
}

extern "C" {

void glfwPollEvents()
{
    using namespace umbral::input::headless;
    if (!ready()) return;
    not_from_a_callback("glfwPollEvents");
    ++state().usage.polls;
    poll();
}

void glfwWaitEvents()
{
    using namespace umbral::input::headless;
    if (!ready()) return;
    not_from_a_callback("glfwWaitEvents");
    ++state().usage.waits;
    wait();
}

void glfwWaitEventsTimeout(double timeout)
{
    using namespace umbral::input::headless;
    if (!ready()) return;
    not_from_a_callback("glfwWaitEventsTimeout");
    if (!(timeout >= 0 && timeout <= 1e300))
        return report(GLFW_INVALID_VALUE, "Invalid time " + std::to_string(timeout));
    ++state().usage.waits;
    wait_until(state().now + timeout);
}

void glfwPostEmptyEvent()
{
    using namespace umbral::input::headless;
    if (ready()) state().woken = true;
}
}
