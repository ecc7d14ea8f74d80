#include <umbral/input/random_script.hpp>
#include <umbral/record/driver.hpp>

#include "../varied_script.hpp"
#include "scripts.hpp"
#include "three_skies.hpp"

namespace umbral {
namespace {

using namespace interaction;

/// Other places, times and buttons: what is asked of the modes is the same for all.
constexpr ScriptNumbers any_hand{.times = true, .buttons = true};
constexpr int all_events = 1500;  // more than any script has

void name_columns(Recorder& out)
{
    out.columns("states", "cursor/2, buttons down");
    out.columns("calls", "calls of glfwPollEvents, calls of glfwWaitEvents");
}

void record_samples(Recorder& out, const input::EventScript& script, double step)
{
    name_columns(out);
    InputTrial trial(out, script);
    trial.install();
    for (double time = step; !trial.script_is_over(); time += step) {
        trial.pass(time);
        trial.sample();
        trial.sample();  // changes nothing
    }
}

/// Reads the queue now and then, a few events at a time. In between a key is pressed, repeated and released for which
/// GLFW has no name.
void record_queue(Recorder& out, const input::EventScript& script, double step, int at_a_time, int session = 0)
{
    InputTrial trial(out, script, session);
    trial.install();
    trial.take(1);
    constexpr std::array unknown_key = {GLFW_PRESS, GLFW_REPEAT, GLFW_RELEASE};
    std::size_t pass = 0;
    for (double time = step; !trial.script_is_over(); time += step) {
        trial.pass(time);
        if (pass < unknown_key.size()) trial.unknown_key(unknown_key.at(pass++));
        trial.take(at_a_time);
    }
    trial.take(all_events);
    trial.take(1);
}

void record_written_queue(Case& what, Recorder& out, const char* text, double step, int at_a_time)
{
    name_events(out, "events");
    record_queue(out, varied(what.vary, text, any_hand), step, at_a_time);
}

/// Buttons were pressed, and the cursor left the window, before anybody listened; in the next window it is other ones,
/// elsewhere.
void record_late_beginning(Case& what, Recorder& out)
{
    name_events(out, "events", true);
    int session = 0;
    for (const char* const script :
         {"0.1 move 200 100\n0.2 press right\n0.22 press left\n0.25 press 8\n0.3 press 6 -210.5 -90.25\n"
          "0.5 move 220 85\n0.55 release left\n0.6 press middle\n0.65 release 8\n0.7 release right\n0.8 scroll 1 0\n",
          "0.1 move 310.5 20\n0.2 press middle\n0.3 press 5 330 12.25\n0.5 scroll 0 1\n0.6 move 300 40\n"
          "0.65 release 5\n0.7 press right\n"}) {
        InputTrial trial(out, varied(what.vary, script, {.buttons = true}), ++session);
        trial.pass(0.4);
        trial.install();
        trial.pass(0.75);
        trial.take(all_events);
        trial.sample();
    }
}

/// One window ends with buttons down and events that nobody took; the next one knows nothing of it.
void record_two_windows(Case& what, Recorder& out)
{
    name_events(out, "events", true);
    {
        InputTrial first(
            out, varied(what.vary, "0.1 press left 30 40\n0.2 move 300 200\n0.3 press right\n0.4 key A press\n"), 1);
        first.install();
        first.pass(0.5);
        first.take(2);
    }
    record_queue(out, varied(what.vary, "0.1 move 20 10\n0.2 press middle\n0.3 key A press\n"), 0.5, 1, 2);
}

void record_requests(Case& what, Recorder& out)
{
    using enum InputKind;
    name_events(out, "answers");
    name_events(out, "events");
    name_columns(out);
    InputTrial trial(out, varied(what.vary, asked_hand, any_hand));
    trial.install();
    trial.work();  // the first press and release come meanwhile
    trial.request(button_pressed);
    trial.request(button_released);
    trial.take(3);
    for (int i = 0; i < 3; ++i) trial.work();
    for (const InputKind kind : {cursor_moved, scrolled, scrolled, key_released, key_pressed, button_released})
        if (!trial.request(kind)) return;
    trial.sample();
    for (const InputKind kind : {button_pressed, key_pressed})
        if (!trial.request(kind)) return;
    trial.take(all_events);
}

/// Windows that close before, while and just when an answer comes. Each session asks twice.
void record_closing(Case& what, Recorder& out)
{
    using enum InputKind;
    name_events(out, "answers", true);
    name_columns(out);
    struct Session {
        const char* script;
        InputKind first;
        InputKind second;
    };
    const Session sessions[] = {
        {"0.1 move 3 4\n0.2 close\n0.3 press left\n", button_pressed, button_pressed},
        {"0.1 key A press\n0.1 close\n0.2 key B press\n", key_pressed, key_pressed},
        {"0.1 close\n0.1 scroll 0 1\n0.2 scroll 0 2\n", scrolled, scrolled},
        {"0.1 close\n0.4 key C press\n", key_pressed, key_released},
        {"0.1 key D press\n0.3 move 9 9\n", key_released, cursor_moved},
        {"0.1 close\n0.2 press left\n0.3 release left\n0.4 press left\n", button_released, button_pressed},
    };
    int number = 0;
    for (const auto& [script, first, second] : sessions) {
        InputTrial trial(out, varied(what.vary, script, {.buttons = true}), ++number);
        trial.install();
        const bool works_first = std::string_view(script).starts_with("0.1 close\n0.4");
        if (works_first) trial.work();
        if (trial.request(first)) trial.request(second);
    }
    // A program that asks whether to save, and goes on: what came after a request that had no answer answers no later
    // one.
    InputTrial trial(out,
                     varied(what.vary,
                            "0.1 close\n0.2 press left 30 40\n0.3 release left\n0.4 key E press\n"
                            "0.6 press right 50 60\n0.7 scroll 0 1\n0.8 key E release\n0.9 close\n"),
                     ++number);
    trial.install();
    for (const InputKind kind : {button_pressed, button_pressed, key_released, scrolled}) {
        if (!trial.request(kind)) return;
        trial.go_on();
        if (kind == button_pressed) trial.pass(0.5);
    }
}

/// All modes at once: what one of them does is no business of the others.
void record_together(Recorder& out, Random& random)
{
    for (const char* const table : {"answers", "events"}) name_events(out, table, true);
    name_columns(out);
    struct Step {
        std::uint32_t what;
        InputKind kind;
        int count;
    };
    for (int session = 1; session <= 3; ++session) {
        InputTrial trial(out, input::random_script(random, {.gestures = 40}), session);
        std::array<Step, 30> steps{};
        for (Step& step : steps)
            step = {random.below(6), static_cast<InputKind>(random.below(6)), static_cast<int>(random.below(20))};
        trial.install();
        for (const auto& [what, kind, count] : steps) {
            if (what == 0) trial.sample();
            if (what == 1) trial.work();
            if (what == 2) trial.take(count);
            if (what >= 3 && !trial.request(kind)) break;
        }
        trial.take(all_events);
    }
}

Image skies(Case& what, Recorder& out)
{
    const input::EventScript script = turned(what.vary, sky_script(), exposure_middle);
    Image picture(3 * exposure_size, exposure_size);
    const auto show = [&](int place, const char* mode, auto read) {
        ask_in_words(out, [&] { return std::string("// a hand draws stars, seen by ") + mode; });
        Recorder unused;
        InputTrial trial(unused, script);
        trial.install();
        SkyPainter painter;
        read(trial, painter);
        painter.exposure.develop(picture, place * exposure_size);
        out.tile("skies", place * exposure_size, 0, exposure_size, exposure_size);
    };
    show(0, "sample_mouse", [](InputTrial& trial, SkyPainter& painter) {
        for (double time = 0.06; !trial.script_is_over(); time += 0.06) {
            trial.pass(time);
            painter.see(sample_mouse(trial.window()));
        }
    });
    show(1, "request_event", [](InputTrial& trial, SkyPainter& painter) {
        for (int i = 0; i < all_events; ++i) {
            const auto event = request_event(trial.window(), InputKind::button_pressed);
            if (!event) return;
            painter.see(event->after);
            painter.see({event->after.cursor, 0});
        }
    });
    show(2, "next_event", [](InputTrial& trial, SkyPainter& painter) {
        for (double time = 0.06; !trial.script_is_over(); time += 0.06) {
            trial.pass(time);
            for (int i = 0; i < all_events; ++i) {
                const auto event = next_event(trial.window());
                if (!event) break;
                painter.see(event->after);
            }
        }
    });
    return picture;
}

void record_random_queue(Recorder& out, Random& random)
{
    name_events(out, "events", true);
    int session = 0;
    for (const int at_a_time : {2, 5, all_events})
        record_queue(out, input::random_script(random, {.gestures = 25}), 0.21, at_a_time, ++session);
    // A program that is busy all the time: hundreds of events wait for it.
    record_queue(out, input::random_script(random, {.gestures = 80}), 0.21, 0, ++session);
}

}

const Driver driver = {
    {"sample", [](Case& c, Recorder& out) { record_samples(out, varied(c.vary, sampled_hand, any_hand), 0.25); }},
    {"random sample",
     [](Case& c, Recorder& out) { record_samples(out, input::random_script(c.random, {.gestures = 60}), 0.11); }},
    {"queue", [](Case& c, Recorder& out) { record_written_queue(c, out, queued_hand, 0.42, 5); }},
    {"lost", [](Case& c, Recorder& out) { record_written_queue(c, out, lost_hand, 0.125, 2); }},
    {"late", [](Case& c, Recorder& out) { record_late_beginning(c, out); }},
    {"two windows", [](Case& c, Recorder& out) { record_two_windows(c, out); }},
    {"random queue", [](Case& c, Recorder& out) { record_random_queue(out, c.random); }},
    {"request", [](Case& c, Recorder& out) { record_requests(c, out); }},
    {"closing", [](Case& c, Recorder& out) { record_closing(c, out); }},
    {"together", [](Case& c, Recorder& out) { record_together(out, c.random); }},
    {"picture", [](Case& c, Recorder& out) { out.image("skies", skies(c, out)); }},
};

}
