#include <kit/script_questions.hpp>
#include <kit/varied.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../varied_script.hpp"
#include "light_painting.hpp"
#include "sessions.hpp"

namespace umbral {
namespace {

using namespace interaction;

/// Each session is a question; its rows are what the loop did, and the session's number, so that no row of one counts
/// as another's. `counted`: also how often it polled and waited.
void record(Recorder& out, const NamedLoop& loop, const std::vector<LoopSession>& sessions, bool counted = false)
{
    out.text("rounds.names", loop_row_names());
    if (counted) out.columns("calls", "calls of glfwPollEvents, calls of glfwWaitEvents");
    float number = 0;
    for (LoopSession session : sessions) {
        ++number;
        session.script = script_asked(out, loop.name, session.script);
        ask_in_script(
            out, loop.name, [&] { return session.script; }, [&] { return told(loop, session); });
        const LoopResult result = play(loop, session);
        float heard = 0;
        for (const LoopRow& row : result.rows) {
            if (!result.stopped.empty() && &row == &result.rows.back()) out.refused("rounds", result.stopped);
            const bool tells_flags = row[0] == 6;
            if (!tells_flags) heard = row[1];
            out.append("rounds", glm::vec3(tells_flags ? first_left_code + row[1] : row[0], heard, number));
        }
        if (counted) out.append("calls", glm::vec2(result.usage.polls, result.usage.waits));
    }
}

/// Sessions that are written down. Varied, they come in another order, sooner or later, and behind other keys.
void record_written(Case& what, Recorder& out, const NamedLoop& loop, std::vector<LoopSession> sessions,
                    bool counted = false)
{
    for (LoopSession& session : sessions)
        session.script =
            behind_other_keys(what.vary, varied(what.vary, session.script, {.times = true}), {GLFW_KEY_R, GLFW_KEY_B});
    record(out, loop, in_random_order(what.vary, std::move(sessions)), counted);
}

void record_random(Recorder& out, const NamedLoop& loop, Random& random)
{
    std::vector<LoopSession> sessions;
    for (int i = 0; i < 40; ++i) sessions.push_back(random_loop_session(random));
    record(out, loop, sessions);
}

/// Two or three lists of sessions, one behind the other.
std::vector<LoopSession> together(std::vector<LoopSession> all, const std::vector<LoopSession>& more)
{
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// Where a hand begins to draw.
glm::dvec2 first_place(const input::EventScript& script)
{
    const auto* const move = std::get_if<input::CursorMove>(&script.front().event);
    return move != nullptr ? move->place : exposure_middle;
}

Image painted(Case& what, Recorder& out)
{
    struct Part {
        const NamedLoop& loop;
        const char* scene;
        LightPainter::Lights lights;
        int rest;
        input::EventScript script;
    };
    const Part parts[] = {
        {waiting_loop, "the pointer is a light, and draws", pointer_light, 0,
         turned(what.vary, hand_draws_a_rose(), exposure_middle)},
        {animated_loop, "three lights go round", planet_lights, 0,
         varied(what.vary, "2.2 key ESCAPE press\n", {.times = true})},
        {switching_loop, "a light goes round the pointer", moon_light, 30,
         turned(what.vary, moon_and_hand(), exposure_middle)},
    };
    Image picture(3 * exposure_size, exposure_size);
    int left = 0;
    for (const auto& [loop, scene, lights, rest, script] : parts) {
        ask_in_words(out, [&] {
            return "// " + std::string(scene) + "; each frame is added to the picture\n" + loop.name +
                   "(window, program, flags);";
        });
        LightPainter painter(lights, rest);
        (void)run_by(loop, painter, script, {.pointer = first_place(script), .on_frame = [&] { painter.shown(); }});
        painter.exposure.develop(picture, left);
        out.tile("exposure", left, 0, exposure_size, exposure_size);
        left += exposure_size;
    }
    return picture;
}

}

const Driver driver = {
    {"waiting",
     [](Case& c, Recorder& out) { record_written(c, out, waiting_loop, together(needs(), pauses()), true); }},
    {"waiting refined", [](Case& c, Recorder& out) { record_written(c, out, waiting_loop, refinements()); }},
    {"waiting ended", [](Case& c, Recorder& out) { record_written(c, out, waiting_loop, endings()); }},
    {"waiting minimised", [](Case& c, Recorder& out) { record_written(c, out, waiting_loop, minimised(), true); }},
    {"animated",
     [](Case& c, Recorder& out) {
         record_written(c, out, animated_loop, together(together(motions(), needs()), refinements()));
     }},
    {"animated ended", [](Case& c, Recorder& out) { record_written(c, out, animated_loop, endings()); }},
    {"animated minimised", [](Case& c, Recorder& out) { record_written(c, out, animated_loop, minimised(), true); }},
    {"switching",
     [](Case& c, Recorder& out) {
         record_written(c, out, switching_loop, together(together(switches(), motions()), refinements()), true);
     }},
    {"switching ended",
     [](Case& c, Recorder& out) { record_written(c, out, switching_loop, together(endings(), minimised())); }},
    {"random waiting", [](Case& c, Recorder& out) { record_random(out, waiting_loop, c.random); }},
    {"random animated", [](Case& c, Recorder& out) { record_random(out, animated_loop, c.random); }},
    {"random switching", [](Case& c, Recorder& out) { record_random(out, switching_loop, c.random); }},
    {"picture", [](Case& c, Recorder& out) { out.image("exposure", painted(c, out)); }},
};

}
