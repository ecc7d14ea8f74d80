#pragma once

#include <spawn.h>
#include <sys/wait.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <umbral/input/events.hpp>
#include <umbral/input/glfw.hpp>
#include <vector>

extern char** environ;

/// What a user does to a window on a display, done by xdotool.
///
/// Nothing here waits for a time. xdotool ends when the display has done what it was told; asking GLFW for the pointer
/// is a question to the same display, so that when the answer is there, so are all events; then they are delivered.
/// Hence the same lines on a machine under any load.
namespace umbral::input {

using Words = std::vector<std::string>;

inline void xdotool(const Words& words)
{
    std::vector<char*> arguments{const_cast<char*>("xdotool")};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t process = 0;
    int status = 0;
    if (posix_spawnp(&process, "xdotool", nullptr, nullptr, arguments.data(), environ) != 0 ||
        waitpid(process, &status, 0) != process || status != 0)
        throw std::runtime_error("xdotool " + words.front() + " failed");
}

/// Delivers every event that the display has made until now.
inline void deliver(GLFWwindow* window)
{
    double ignored = 0;
    glfwGetCursorPos(window, &ignored, &ignored);
    glfwPollEvents();
}

/// A key for xdotool, by its place on the keyboard: by name, it would press Shift where it thinks that the name needs
/// it. X's number of Escape is 9, which xdotool takes for the digit.
inline std::string key_name(int key)
{
    return key == GLFW_KEY_ESCAPE ? "Escape" : std::to_string(glfwGetKeyScancode(key));
}

/// One event of a script in xdotool's words. X numbers buttons 1 left, 2 middle, 3 right, 4 to 7 the wheel: up, down,
/// left, right.
class Hands {
public:
    explicit Hands(GLFWwindow* window) : window_(window) { glfwGetWindowPos(window, &corner_.x, &corner_.y); }

    void operator()(const CursorMove& event) const { xdotool(to(event.place)); }

    void operator()(const MouseButton& event) const
    {
        if (event.placed) (*this)(CursorMove{event.place});
        if (event.placed) deliver(window_);
        constexpr const char* numbers[] = {"1", "3", "2"};
        xdotool({event.pressed ? "mousedown" : "mouseup", numbers[event.button]});
    }

    void operator()(const Scroll& event) const
    {
        for (double steps = event.offset.y; steps != 0; steps -= steps > 0 ? 1 : -1)
            xdotool({"click", steps > 0 ? "4" : "5"});
        for (double steps = event.offset.x; steps != 0; steps -= steps > 0 ? 1 : -1)
            xdotool({"click", steps > 0 ? "6" : "7"});
    }

    void operator()(const Key& event) const
    {
        xdotool({event.action == Key::Action::press ? "keydown" : "keyup", key_name(event.key)});
    }

    void operator()(const Resize& event) const
    {
        xdotool({"search", "--name", "^Umbral on a display$", "windowsize", std::to_string(event.size.x),
                 std::to_string(event.size.y)});
    }

    template <class Other>
    void operator()(const Other&) const
    {
        throw std::runtime_error(
            "this event cannot be played with xdotool: keep to buttons, motion, whole steps of the wheel, keys and "
            "sizes");
    }

private:
    [[nodiscard]] Words to(glm::dvec2 place) const
    {
        const glm::ivec2 screen = corner_ + glm::ivec2(place);
        return {"mousemove", std::to_string(screen.x), std::to_string(screen.y)};
    }

    GLFWwindow* window_;
    glm::ivec2 corner_{0};
};

/// A window that has its place on the screen and the keyboard. Without a window manager nobody gives it the focus but
/// xdotool. `client_api`: GLFW_NO_API, or GLFW_OPENGL_API for one that can show frames.
inline GLFWwindow* open_window(int client_api = GLFW_NO_API)
{
    glfwSetErrorCallback(
        [](int code, const char* text) { (void)std::fprintf(stderr, "GLFW error %d: %s\n", code, text); });
    if (glfwInit() == GLFW_FALSE) throw std::runtime_error("glfwInit failed: is DISPLAY set?");
    glfwWindowHint(GLFW_CLIENT_API, client_api);
    GLFWwindow* window = glfwCreateWindow(640, 480, "Umbral on a display", nullptr, nullptr);
    if (window == nullptr) throw std::runtime_error("glfwCreateWindow failed");
    glfwSetWindowPos(window, 200, 150);
    xdotool(
        {"mousemove", "200", "150", "search", "--sync", "--name", "^Umbral on a display$", "windowfocus", "--sync"});
    const auto ready = [&] {
        int x = 0;
        int y = 0;
        deliver(window);
        glfwGetWindowPos(window, &x, &y);
        return x == 200 && y == 150 && glfwGetWindowAttrib(window, GLFW_FOCUSED) != 0;
    };
    for (int i = 0; i < 2000 && !ready(); ++i) glfwWaitEventsTimeout(0.01);
    if (!ready()) throw std::runtime_error("the window did not get its place and the keyboard within 20 s");
    return window;
}

}
