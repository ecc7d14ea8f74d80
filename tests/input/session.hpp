#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <umbral/core/student_error.hpp>
#include <umbral/input/headless.hpp>
#include <umbral/input/script.hpp>
#include <vector>

namespace umbral::input {

/// A session with a window, and a list of what its callbacks heard, one line a call.
class Session {
public:
    explicit Session(const char* script, const HeadlessSettings& settings = {})
        : headless(parse_script(script), settings)
    {
        EXPECT_EQ(glfwInit(), GLFW_TRUE);
        window = glfwCreateWindow(640, 480, "test", nullptr, nullptr);
        glfwSetWindowUserPointer(window, this);
    }

    void say(const std::string& text) { heard.push_back(text); }
    static Session& of(GLFWwindow* window) { return *static_cast<Session*>(glfwGetWindowUserPointer(window)); }

    /// Waits until the script is over.
    void play() const
    {
        while (!headless.script_is_over()) glfwWaitEvents();
    }

    Headless headless;
    GLFWwindow* window = nullptr;
    std::vector<std::string> heard;
};

/// "1.5 -2" of any numbers.
template <class... Numbers>
std::string words(Numbers... numbers)
{
    std::ostringstream text;
    ((text << (text.tellp() > 0 ? " " : "") << numbers), ...);
    return text.str();
}

/// The text of the StudentError that `action` ends with; empty if it does not.
template <class Action>
std::string stopped_by(Action action)
{
    try {
        action();
    } catch (const StudentError& error) {
        return error.what();
    }
    return "";
}

}
