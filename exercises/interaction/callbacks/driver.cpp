#include <algorithm>
#include <cmath>
#include <functional>
#include <kit/scene.hpp>
#include <kit/script_questions.hpp>
#include <optional>
#include <umbral/input/headless.hpp>
#include <umbral/input/random_script.hpp>
#include <umbral/input/script.hpp>
#include <umbral/interaction/callbacks.hpp>
#include <umbral/interaction/orbit_camera.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../command_log.hpp"
#include "../key_callback.hpp"
#include "../script_text.hpp"
#include "../varied_script.hpp"
#include "scripts.hpp"
#include "walk.hpp"

namespace umbral {
namespace {

using namespace interaction;

/// A window that is 0 x 0 has been minimised after it was made.
GLFWwindow* make_window(glm::ivec2 size)
{
    if (size != glm::ivec2(0)) return glfwCreateWindow(size.x, size.y, "Umbral", nullptr, nullptr);
    GLFWwindow* const window = glfwCreateWindow(640, 480, "Umbral", nullptr, nullptr);
    glfwSetWindowSize(window, 0, 0);
    glfwPollEvents();
    return window;
}

/// Plays a script to a window with the unit's callbacks, as its event loop would.
void play(const input::EventScript& script, const input::HeadlessSettings& settings, glm::ivec2 size,
          const std::function<void(GLFWwindow*)>& begin, const std::function<void()>& after_wait)
{
    const input::Headless session(script, settings);
    glfwInit();
    begin(make_window(size));
    while (!session.script_is_over()) {
        glfwWaitEvents();
        after_wait();
    }
}

/// What was done to a window until then: its making, and a line of the script for each event.
std::string told(const input::EventScript& script, glm::ivec2 size, const input::HeadlessSettings& settings,
                 bool listens, double until, bool in_full)
{
    const auto number = [](double value) { return literal::of(value); };
    std::string text =
        "// in a window of " + std::to_string(size.x) + " x " + std::to_string(size.y) + " screen coordinates";
    if (settings.content_scale != glm::dvec2(1))
        text += ", of " + number(settings.content_scale.x) + " x " + number(settings.content_scale.y) + " pixels each";
    text += listens ? ",\n// with a key callback already\n" : "\n";
    text += "install_callbacks(window);";
    // Written scripts are short enough to be seen as they are: what was decisive may be long ago.
    const auto happened = std::ranges::count_if(script, [&](const auto& event) { return event.time <= until; });
    const std::string lines = script_until(script, until, in_full || happened <= 28);
    return lines.empty() ? text : text + '\n' + lines;
}

/// Windows in which gestures are made are square: a wrong aspect costs points where sizes are looked at, and not again
/// in every case.
constexpr glm::ivec2 square{480, 480};
constexpr glm::ivec2 wide{640, 480};

/// Records the commands from `first` to before `end`, which is returned. `session`: from 1 on where a case has several,
/// so that no command of one counts as another's; else 0.
std::size_t append_commands(Recorder& out, const std::vector<CommandRow>& commands, std::size_t first, std::size_t end,
                            int session = 0)
{
    for (; first < end; ++first) {
        std::vector<float> row(commands[first].begin(), commands[first].end());
        if (session > 0) row.push_back(static_cast<float>(session));
        out.append("commands", std::span<const float>(row));
    }
    return end;
}

void record(Recorder& out, const input::EventScript& events, glm::ivec2 size,
            const input::HeadlessSettings& settings = {}, bool listens = false, int session = 0)
{
    const input::EventScript script = script_asked(out, "the session", events);
    struct Moment {
        double time;
        std::size_t rows;  ///< of commands until then
    };
    std::vector<Moment> moments;
    std::optional<LoggedWindow> window;
    const auto begin = [&](GLFWwindow* made) {
        window.emplace(made, listens);
        moments.push_back({-1, window->rows().size()});
    };
    const auto after_wait = [&] {
        window->look();
        moments.push_back({glfwGetTime(), window->rows().size()});
    };
    play(script, settings, size, begin, after_wait);
    std::size_t next = 0;
    for (const Moment& moment : moments) {
        ask_in_script(
            out, "the session", [&] { return events_until(script, moment.time); },
            [&] { return told(script, size, settings, listens, moment.time, out.questions()->inquiry().in_full); });
        next = append_commands(out, window->rows(), next, moment.rows, session);
    }
}

void record_text(Case& what, Recorder& out, const char* text)
{
    out.text("commands.names", command_names(false));
    record(out, varied(what.vary, text), square);
}

void record_keys(Case& what, Recorder& out, bool listens)
{
    out.text("commands.names", command_names(false));
    const std::vector<int> others{GLFW_KEY_R, GLFW_KEY_1, GLFW_KEY_2, GLFW_KEY_3, GLFW_KEY_4};
    record(out, behind_other_keys(what.vary, input::parse_script(keys), others), square, {}, listens);
}

/// A window is closed in the middle of a drag; then there is another one, with Controls of its own.
void record_two_windows(Case& what, Recorder& out)
{
    out.text("commands.names", command_names(true));
    record(out, varied(what.vary, "0.1 press left 10 10\n0.2 move 30 20\n"), wide, {}, false, 1);
    record(out,
           varied(what.vary,
                  "0.1 move 50 60\n0.2 move 70 80\n0.3 press right\n0.4 move 71 79\n0.5 release right\n"
                  "0.6 press left\n0.7 move 75 85\n"),
           wide, {}, false, 2);
}

/// Sizes of a window; and one that is minimised when the program begins to listen.
void record_sizes(Case& what, Recorder& out)
{
    out.text("commands.names", command_names(true));
    const input::HeadlessSettings fine{.content_scale = {2, 2}};
    record(out, varied(what.vary, windows), wide, fine, false, 1);
    record(out, varied(what.vary, "0.1 resize 300 200\n0.2 resize 0 0\n0.3 resize 300 200\n"), {0, 0}, fine, false, 2);
}

void record_random(Recorder& out, Random& random)
{
    out.text("commands.names", command_names(true));
    for (int session = 1; session <= 6; ++session) {
        const input::EventScript script = input::random_script(random, {.gestures = 60});
        record(out, script, wide, {.content_scale = glm::dvec2(session % 2 == 1 ? 1 : 1.5)}, false, session);
    }
}

/// Sessions whose gestures do not wait for each other; in the last one with a key callback that was there before.
void record_any_order(Recorder& out, Random& random)
{
    out.text("commands.names", command_names(true));
    for (int session = 1; session <= 5; ++session) {
        const input::EventScript script = Walk(random).record(160);
        record(out, script, wide, {.content_scale = glm::dvec2(session % 2 == 1 ? 1 : 2)}, session == 5, session);
    }
}

/// The key callbacks of two windows, of which one had another before, called as GLFW would for keys and locks that a
/// script cannot press.
void record_any_key(Recorder& out, Random& random)
{
    out.text("commands.names", command_names(true));
    const input::Headless session({});
    glfwInit();
    struct Keyboard {
        GLFWwindow* window;
        LoggedWindow logged;
        GLFWkeyfun on_key = key_callback_of(window);
        std::size_t rows = logged.rows().size();

        Keyboard(GLFWwindow* made, bool listens) : window(made), logged(made, listens) {}
    };
    Keyboard first(make_window(square), true);
    Keyboard second(make_window(square), false);
    for (int i = 0; i < 60; ++i) {
        const AnyKey event = any_key(random);
        Keyboard& asked = i % 4 == 3 ? second : first;
        ask_in_words(out, [&] {
            return "// on_key: the key callback of this window then\ninstall_callbacks(window); // " +
                   std::string(&asked == &first ? "the first one, with a key callback already"
                                                : "the second one, without a key callback") +
                   '\n' + told(event);
        });
        if (asked.on_key != nullptr) asked.on_key(asked.window, event.key, event.scancode, event.action, event.mods);
        asked.logged.look();
        asked.rows =
            append_commands(out, asked.logged.rows(), asked.rows, asked.logged.rows().size(), &asked == &first ? 1 : 2);
    }
}

/// A camera that does what it is told. Panning shifts the picture.
class ObedientCamera final : public Commands {
public:
    void orbit(glm::dvec2 drag) override { camera_->drag(drag.x, drag.y); }
    void pan(glm::dvec2 drag) override { shift_ += 0.02 * drag; }
    void zoom(double factor) override { camera_->scroll(-std::log(factor) / std::log(1.1)); }
    void reset() override { camera_->reset(); }
    void view_mode(int) override {}
    void viewport(int, int, double) override {}

    [[nodiscard]] Image picture() const
    {
        return draw_scene(glm::translate(glm::mat4(1), glm::vec3(shift_, 0)) * camera_->view());
    }

private:
    std::unique_ptr<OrbitCamera> camera_ =
        make_orbit_camera({.target = {0, 0.35, 0}, .distance = 8, .viewport_height = 256});
    glm::dvec2 shift_{0};
};

Image picture_after(Recorder& out, const input::EventScript& script)
{
    constexpr glm::ivec2 size{256, 256};
    ask_in_words(out, [&] { return told(script, size, {}, false, script.back().time, true); });
    ObedientCamera camera;
    Controls controls{.commands = &camera};
    const auto begin = [&](GLFWwindow* window) {
        glfwSetWindowUserPointer(window, &controls);
        install_callbacks(window);
    };
    play(script, {}, size, begin, [] {});
    return camera.picture();
}

}

const Driver driver = {
    {"each kind", [](Case& c, Recorder& out) { record_text(c, out, each_kind); }},
    {"orbit", [](Case& c, Recorder& out) { record_text(c, out, orbiting); }},
    {"pan", [](Case& c, Recorder& out) { record_text(c, out, panning); }},
    {"two buttons", [](Case& c, Recorder& out) { record_text(c, out, two_buttons); }},
    {"outside", [](Case& c, Recorder& out) { record_text(c, out, outside); }},
    {"wheel", [](Case& c, Recorder& out) { record_text(c, out, wheel); }},
    {"keys", [](Case& c, Recorder& out) { record_keys(c, out, false); }},
    {"keys passed on", [](Case& c, Recorder& out) { record_keys(c, out, true); }},
    {"any key", [](Case& c, Recorder& out) { record_any_key(out, c.random); }},
    {"any order", [](Case& c, Recorder& out) { record_any_order(out, c.random); }},
    {"window size", [](Case& c, Recorder& out) { record_sizes(c, out); }},
    {"two windows", [](Case& c, Recorder& out) { record_two_windows(c, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(out, c.random); }},
    {"picture",
     [](Case& c, Recorder& out) { out.image("colours", picture_after(out, varied(c.vary, a_look_around))); }},
};

}
