#pragma once

#include <array>
#include <kit/input_words.hpp>
#include <string>
#include <umbral/interaction/callbacks.hpp>
#include <vector>

/// Commands as rows of numbers, as they came: what callbacks are judged by, without a screen and (in a test) with one.
namespace umbral::interaction {

/// First its code, then its numbers.
using CommandRow = std::array<float, 4>;

/// What the codes mean, for reports; keys that are passed on have codes of their own (key_code). `by_session`: behind
/// its four numbers, a row says which session it comes from.
inline std::string command_names(bool by_session)
{
    if (!by_session)
        return "1 orbit\n2 pan\n3 zoom\n4 reset\n5 view mode\n6 viewport\n7 closing\n" +
               key_names("scancode, modifiers");
    return "1 orbit: drag/2, -, session\n2 pan: drag/2, -, session\n3 zoom: factor, -/2, session\n"
           "4 reset: -/3, session\n5 view mode: mode, -/2, session\n6 viewport: size/2, aspect, session\n"
           "7 closing: -/3, session\n" +
           key_names("scancode, modifiers, -, session");
}

class CommandLog : public Commands {
public:
    void orbit(glm::dvec2 drag) override { add(1, drag.x, drag.y); }
    void pan(glm::dvec2 drag) override { add(2, drag.x, drag.y); }
    void zoom(double factor) override { add(3, factor); }
    void reset() override { add(4); }
    void view_mode(int mode) override { add(5, mode); }
    void viewport(int width, int height, double aspect) override { add(6, width, height, aspect); }
    void closing() { add(7); }
    void key_passed_on(int key, int scancode, int action, int mods) { add(key_code(key, action), scancode, mods); }

    std::vector<CommandRow> rows;

private:
    void add(double code, double a = 0, double b = 0, double c = 0)
    {
        rows.push_back({static_cast<float>(code), static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)});
    }
};

/// A window whose commands are logged: what was there before install_callbacks, and what is to be looked at after each
/// wait.
class LoggedWindow {
public:
    /// The window stays the caller's, and must live as long. `listens`: a key callback was there before, and logs what
    /// is passed on to it.
    LoggedWindow(GLFWwindow* window, bool listens) : window_(window)
    {
        listener_.commands = &listener_.log;
        glfwSetWindowUserPointer(window, static_cast<Controls*>(&listener_));
        if (listens)
            glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int scancode, int action, int mods) {
                listener_of(from).log.key_passed_on(key, scancode, action, mods);
            });
        // Only what the callbacks ask for counts as closing; a user who clicks at the cross is not heard.
        glfwSetWindowCloseCallback(window, [](GLFWwindow* from) { glfwSetWindowShouldClose(from, GLFW_FALSE); });
        install_callbacks(window);
    }
    LoggedWindow(const LoggedWindow&) = delete;
    LoggedWindow& operator=(const LoggedWindow&) = delete;
    ~LoggedWindow() = default;

    /// To be called after each glfwWaitEvents: notes that the window was asked to close, and keeps it open.
    void look()
    {
        if (glfwWindowShouldClose(window_) == GLFW_FALSE) return;
        listener_.log.closing();
        glfwSetWindowShouldClose(window_, GLFW_FALSE);
    }

    [[nodiscard]] const std::vector<CommandRow>& rows() const { return listener_.log.rows; }

private:
    struct Listener : Controls {
        CommandLog log;
    };

    static Listener& listener_of(GLFWwindow* window)
    {
        return static_cast<Listener&>(*static_cast<Controls*>(glfwGetWindowUserPointer(window)));
    }

    GLFWwindow* window_;
    Listener listener_;
};

}
