#pragma once

#include <array>
#include <string>
#include <string_view>
#include <umbral/core/student_error.hpp>
#include <umbral/input/headless.hpp>
#include <umbral/interaction/input_modes.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/recorder.hpp>

#include "../script_text.hpp"

/// A program that reads its input in all three modes while a script is played to its window, and records what it gets.
namespace umbral::interaction {

/// What the codes of rows mean; a row of the table `answers` has its time in "answers times", and so on.
inline constexpr std::string_view input_row_names =
    "1 button pressed: button, change/2, cursor/2\n2 button released: button, change/2, cursor/2\n"
    "3 cursor moved: 0, change/2, cursor/2\n4 scrolled: 0, change/2, cursor/2\n"
    "5 key pressed: key, change/2, cursor/2\n6 key released: key, change/2, cursor/2\n7 no event\n8 stopped\n";
inline constexpr std::string_view input_time_names =
    "1 button pressed: time\n2 button released: time\n3 cursor moved: time\n4 scrolled: time\n5 key pressed: time\n"
    "6 key released: time\n7 no event\n8 stopped\n";
inline constexpr std::string_view input_button_names =
    "1 button pressed: buttons down\n2 button released: buttons down\n3 cursor moved: buttons down\n"
    "4 scrolled: buttons down\n5 key pressed: buttons down\n6 key released: buttons down\n7 no event\n8 stopped\n";

inline constexpr std::array kind_names = {"button_pressed", "button_released", "cursor_moved",
                                          "scrolled",       "key_pressed",     "key_released"};

/// Says once what the rows of a table of events mean.
inline void name_events(Recorder& out, const std::string& table)
{
    out.text(table + ".names", input_row_names);
    out.text(table + " times.names", input_time_names);
    out.text(table + " buttons.names", input_button_names);
}

class InputTrial {
public:
    /// A frame takes a quarter of a second here: glfwSwapBuffers stands for work during which nobody reads input.
    InputTrial(Recorder& out, const input::EventScript& script)
        : out_(out),
          script_(script),
          session_(script, {.pointer = {12, 7.5}, .frame_seconds = 0.25, .polls_after_closing = 20})
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
        append_rows(table, 1 + static_cast<float>(static_cast<int>(event->kind)), *event);
    }

    void append_rows(const std::string& table, float code, const InputEvent& event)
    {
        const glm::vec2 change(event.change);
        const glm::vec2 cursor(event.after.cursor);
        const std::array row = {code, static_cast<float>(event.code), change.x, change.y, cursor.x, cursor.y};
        out_.append(table, std::span<const float>(row));
        out_.append(table + " times", glm::vec2(code, event.time));
        out_.append(table + " buttons", glm::vec2(code, event.after.buttons));
    }

    /// `ahead`: seconds of the script that lie before the program, and are shown too.
    void tell(const std::string& call, double ahead)
    {
        ask_in_words(out_, [&] {
            const double now = glfwGetTime();
            const bool in_full = out_.questions()->inquiry().in_full;
            return "install_input(window);  // at " + std::to_string(installed_) + " s\n" +
                   script_until(script_, now + ahead, in_full) + "\n// at " + std::to_string(now) + " s\n" + call;
        });
    }

    Recorder& out_;
    input::EventScript script_;
    InputMemory memory_;
    input::Headless session_;
    GLFWwindow* window_ = nullptr;
    double installed_ = 0;
};

}
