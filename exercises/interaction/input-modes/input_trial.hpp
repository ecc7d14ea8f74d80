#pragma once

#include <array>
#include <kit/input_words.hpp>
#include <kit/script_questions.hpp>
#include <string>
#include <string_view>
#include <umbral/core/student_error.hpp>
#include <umbral/input/headless.hpp>
#include <umbral/interaction/input_modes.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/recorder.hpp>
#include <vector>

#include "../key_callback.hpp"
#include "../script_text.hpp"

/// A program that reads its input in all three modes while a script is played to its window, and records what it gets.
namespace umbral::interaction {

/// What the codes of rows mean, behind which stand numbers that are called `numbers`, or, where no event came, `none`;
/// keys and buttons have codes of their own.
inline std::string input_row_names(const std::string& numbers, const std::string& none)
{
    return "3 cursor moved: " + numbers + "\n4 scrolled: " + numbers + "\n7 no event: " + none +
           "\n8 stopped: " + none + "\n9 cursor moved or scrolled, with a code that is not 0: " + numbers + "\n" +
           button_names(numbers) + key_names(numbers);
}

inline constexpr std::array kind_names = {"button_pressed", "button_released", "cursor_moved",
                                          "scrolled",       "key_pressed",     "key_released"};

/// Says once what the rows of a table of events mean; a row of the table `answers` has its time in "answers times", and
/// so on. `by_session`: the last number of a row is that of its session.
inline void name_events(Recorder& out, const std::string& table, bool by_session = false)
{
    const std::string session = by_session ? ", session" : "";
    out.text(table + ".names", input_row_names("change/2, cursor/2" + session, "-/4" + session));
    out.text(table + " times.names", input_row_names("time" + session, "-" + session));
    out.text(table + " buttons.names", input_row_names("buttons down" + session, "-" + session));
}

/// The code of an event's rows.
inline float code_of(const InputEvent& event)
{
    using enum InputKind;
    if (event.kind == key_pressed || event.kind == key_released)
        return key_code(event.code, event.kind == key_pressed ? GLFW_PRESS : GLFW_RELEASE);
    if (event.kind == button_pressed || event.kind == button_released)
        return button_code(event.code, event.kind == button_pressed);
    return event.code != 0 ? 9 : 1 + static_cast<float>(static_cast<int>(event.kind));
}

class InputTrial {
public:
    /// A frame takes a quarter of a second here: glfwSwapBuffers stands for work during which nobody reads input.
    /// `session`: from 1 on where a case has several, so that no event of one counts as another's; else 0.
    InputTrial(Recorder& out, const input::EventScript& script, int session = 0)
        : out_(out),
          script_(script_asked(out, "the session", script)),
          number_(session),
          session_(script_, {.pointer = {12, 7.5}, .frame_seconds = 0.25, .polls_after_closing = 20})
    {
        glfwInit();
        window_ = glfwCreateWindow(640, 480, "Umbral", nullptr, nullptr);
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(1);
        glfwSetWindowUserPointer(window_, &memory_);
    }

    void install()
    {
        install_input(window_);
        installed_ = glfwGetTime();
    }

    /// Lets time pass until a moment, in which GLFW delivers events.
    void pass(double time) const
    {
        while (glfwGetTime() < time) glfwWaitEventsTimeout(time - glfwGetTime());
    }
    /// The program that was asked to close does not.
    void go_on() const { glfwSetWindowShouldClose(window_, GLFW_FALSE); }
    /// A key for which GLFW has no name is pressed or released: no script can say so, so that the window's callback is
    /// called as GLFW would.
    void unknown_key(int action)
    {
        const GLFWkeyfun callback = key_callback_of(window_);
        unknown_keys_ += std::string("// at ") + std::to_string(glfwGetTime()) + " s: GLFW_KEY_UNKNOWN, " +
                         std::string(input_words::actions.at(static_cast<std::size_t>(action))) + "\n";
        if (callback != nullptr) callback(window_, GLFW_KEY_UNKNOWN, 151, action, 0);
    }
    /// Works for a quarter of a second, in which GLFW delivers none.
    void work() const { glfwSwapBuffers(window_); }

    MouseState sample(const char* table = "states")
    {
        tell("sample_mouse(window)", 0);
        const MouseState state = sample_mouse(window_);
        out_.append(table, glm::vec3(state.cursor, state.buttons));
        record_calls();
        return state;
    }

    /// False if it would have waited for ever.
    bool request(InputKind kind, const char* table = "answers")
    {
        tell("request_event(window, InputKind::" + std::string(kind_names.at(static_cast<std::size_t>(kind))) + ")", 1);
        try {
            append(table, request_event(window_, kind));
            record_calls();
            return true;
        } catch (const StudentError& error) {
            out_.refused(table, error.what());
            append_rows(table, 8, {});
            return false;
        }
    }

    /// Takes so many events out of the queue; false if it was empty.
    bool take(int count, const char* table = "events")
    {
        for (int i = 0; i < count; ++i) {
            tell("next_event(window)", 0);
            const std::optional<InputEvent> event = next_event(window_);
            append(table, event);
            if (!event) return false;
        }
        return true;
    }

    [[nodiscard]] GLFWwindow* window() const { return window_; }
    [[nodiscard]] bool script_is_over() const { return session_.script_is_over(); }

private:
    /// How often GLFW was asked for events until now, by anybody.
    void record_calls() { out_.append("calls", glm::vec2(session_.usage().polls, session_.usage().waits)); }

    void append(const std::string& table, const std::optional<InputEvent>& event)
    {
        if (!event) return append_rows(table, 7, {});
        append_rows(table, code_of(*event), *event);
    }

    void append_rows(const std::string& table, float code, const InputEvent& event)
    {
        const glm::vec2 change(event.change);
        const glm::vec2 cursor(event.after.cursor);
        append_row(table, {code, change.x, change.y, cursor.x, cursor.y});
        append_row(table + " times", {code, static_cast<float>(event.time)});
        append_row(table + " buttons", {code, static_cast<float>(event.after.buttons)});
    }

    void append_row(const std::string& table, std::vector<float> row)
    {
        if (number_ > 0) row.push_back(static_cast<float>(number_));
        out_.append(table, std::span<const float>(row));
    }

    /// What a question is about: the oldest event that waits in the queue, as a solution that keeps it there says, or
    /// now.
    [[nodiscard]] double moment_of(std::string_view call, double now) const
    {
        const bool is_of_queue = call.starts_with("next_event") && !memory_.pending.empty();
        return is_of_queue ? memory_.pending.front().time : now;
    }

    /// `ahead`: seconds of the script that lie before the program, and are shown too.
    void tell(const std::string& call, double ahead)
    {
        const auto events = [&] { return events_until(script_, glfwGetTime()); };
        ask_in_script(out_, "the session", events, [&] {
            const double now = glfwGetTime();
            const bool in_full = out_.questions()->inquiry().in_full;
            return "install_input(window);  // at " + std::to_string(installed_) + " s\n" +
                   script_about(script_, moment_of(call, now + ahead), now + ahead, in_full) + "\n" + unknown_keys_ +
                   "// at " + std::to_string(now) + " s\n" + call;
        });
    }

    Recorder& out_;
    input::EventScript script_;
    int number_;
    InputMemory memory_;
    input::Headless session_;
    GLFWwindow* window_ = nullptr;
    double installed_ = 0;
    std::string unknown_keys_;
};

}
