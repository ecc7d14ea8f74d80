#pragma once

#include <cstddef>
#include <functional>
#include <umbral/input/events.hpp>
#include <umbral/input/glfw.hpp>
#include <vector>

/// GLFW without a screen: libumbral-glfw exports every function of GLFW's header, and plays an event script to one
/// virtual window: the one that was made first. A program may have a second one, which shows whether it tells them
/// apart; only what the program itself does to that one becomes an event there.
///
/// Functions that make sense without a screen behave as GLFW 3.3's documentation says: callbacks run only inside
/// glfwPollEvents and glfwWaitEvents…, setters return the callback before, errors have GLFW's codes. The others end the
/// case with a StudentError that names them. Where the documentation leaves things open (modifier bits are those from
/// before the event, the framebuffer's new size comes before the window's), it does as GLFW does under X11. Two
/// differences, for the sake of repeatable runs: glfwGetCursorPos tells where the pointer was at the last event
/// delivered, not where it is by now; and time is the script's, not the clock's.
namespace umbral::input {

struct HeadlessSettings {
    glm::dvec2 content_scale{1};       ///< pixels of the framebuffer for each screen coordinate; 2 on many laptops
    glm::dvec2 pointer{0};             ///< where the pointer is at first
    double poll_seconds = 1.0 / 1024;  ///< what one glfwPollEvents takes
    double frame_seconds = 1.0 / 64;   ///< what one glfwSwapBuffers takes, if the swap interval is not 0
    double patience_seconds = 1;       ///< how long after its last event the user asks a polling program to close
    std::size_t polls_after_closing = 1000;  ///< how often a program may poll after that before it counts as stuck
    std::function<void()> on_frame{};        ///< called in each glfwSwapBuffers, where a screen would show the frame
};

/// How a program used the window: what the event loop is judged by.
struct Usage {
    std::size_t polls = 0;
    std::size_t waits = 0;       ///< glfwWaitEvents and glfwWaitEventsTimeout
    std::vector<double> frames;  ///< when each glfwSwapBuffers was called
};

/// A session: from here to the end of its life, GLFW's functions act on this script. Not initialised: that is
/// glfwInit's.
///
/// When the script is over, a program that waits is asked to close, and ended with a StudentError if it waits again; a
/// program that polls is asked after a moment. So no loop can hang. Throws std::logic_error if there is a session
/// already.
class Headless {
public:
    explicit Headless(EventScript script, const HeadlessSettings& settings = {});
    ~Headless();
    Headless(const Headless&) = delete;
    Headless& operator=(const Headless&) = delete;

    [[nodiscard]] const Usage& usage() const noexcept;
    /// Have all events of the script been delivered?
    [[nodiscard]] bool script_is_over() const noexcept;
};

}
