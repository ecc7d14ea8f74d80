#pragma once

#include <cstdio>
#include <fstream>
#include <interaction/command_log.hpp>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <umbral/input/script.hpp>

/// What the two programs share that play one script, one to a window on a display and one without: the lines that they
/// print.
namespace umbral::input {

inline EventScript read_script(const char* path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error(std::string("cannot read '") + path + "'");
    return parse_script(std::string(std::istreambuf_iterator<char>(file), {}), path);
}

/// Prints every callback as it comes.
inline void print_raw_events(GLFWwindow* window)
{
    glfwSetMouseButtonCallback(window, [](GLFWwindow*, int button, int action, int mods) {
        std::printf("button %d %d %d\n", button, action, mods);
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow*, double x, double y) { std::printf("cursor %g %g\n", x, y); });
    glfwSetScrollCallback(window, [](GLFWwindow*, double x, double y) { std::printf("scroll %g %g\n", x, y); });
    glfwSetKeyCallback(window, [](GLFWwindow*, int key, int scancode, int action, int mods) {
        std::printf("key %d %d %d%s\n", key, action, mods,
                    scancode == glfwGetKeyScancode(key) ? "" : " with another key's scancode");
    });
    glfwSetCharCallback(window, [](GLFWwindow*, unsigned code) { std::printf("char %u\n", code); });
    glfwSetFramebufferSizeCallback(
        window, [](GLFWwindow*, int width, int height) { std::printf("framebuffer %d %d\n", width, height); });
    glfwSetWindowSizeCallback(window,
                              [](GLFWwindow*, int width, int height) { std::printf("size %d %d\n", width, height); });
}

/// Prints what happens in a window, as `mode` says: "raw" callbacks, or "commands" that the reference's callbacks make
/// of them.
class Printer {
public:
    Printer(GLFWwindow* window, const std::string& mode)
    {
        if (mode == "raw")
            print_raw_events(window);
        else
            commands_ = std::make_unique<interaction::LoggedWindow>(window, true);
    }

    /// To be called after each delivery of events.
    void look()
    {
        if (commands_) commands_->look();
    }

    /// A key's scancode is left out: it is the keyboard's own.
    void finish() const
    {
        if (!commands_) return;
        const float first_key = key_code(GLFW_KEY_UNKNOWN, GLFW_RELEASE);
        for (const interaction::CommandRow& row : commands_->rows())
            if (row[0] < first_key)
                std::printf("%g %g %g %g\n", double{row[0]}, double{row[1]}, double{row[2]}, double{row[3]});
            else
                std::printf("%g %g\n", double{row[0]}, double{row[2]});
    }

private:
    std::unique_ptr<interaction::LoggedWindow> commands_;
};

}
