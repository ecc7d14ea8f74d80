// play-lab4-real: lab 4's program in a window of the real GLFW, with the system's OpenGL, on a display where xdotool
// presses the keys. The program is the reference as it is handed in; it is linked so that its calls of glfwSwapBuffers
// come by here first (--wrap).
//
// Nothing here waits for a time: after each frame that answers a key's release, the next key is pressed, delivered, and
// released; the frame after that shows what came of it.

#include <spawn.h>
#include <sys/wait.h>

#include "play_lab4.hpp"

extern char** environ;

namespace {

using namespace umbral::texturing;

/// What the frames' function knows: GLFW gives it nothing but the window.
struct Play {
    ColouredBoxes earlier;
    std::size_t next = 0;  ///< key
    bool begun = false;
    bool failed = false;
};

Play& play()
{
    static Play only;
    return only;
}

bool xdotool(std::vector<std::string> words)
{
    std::vector<char*> arguments{const_cast<char*>("xdotool")};
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t process = 0;
    int status = 0;
    return posix_spawnp(&process, "xdotool", nullptr, nullptr, arguments.data(), environ) == 0 &&
           waitpid(process, &status, 0) == process && status == 0;
}

/// Delivers every event that the display has made until now: the question about the pointer goes to the same display.
void deliver(GLFWwindow* window)
{
    double ignored = 0;
    glfwGetCursorPos(window, &ignored, &ignored);
    glfwPollEvents();
}

bool take_the_keyboard(GLFWwindow* window)
{
    if (!xdotool({"search", "--sync", "--name", "^Lab 4$", "windowfocus", "--sync"})) return false;
    for (int i = 0; i < 2000 && glfwGetWindowAttrib(window, GLFW_FOCUSED) == 0; ++i) glfwWaitEventsTimeout(0.01);
    return glfwGetWindowAttrib(window, GLFW_FOCUSED) != 0;
}

}

extern "C" {

void __real_glfwSwapBuffers(GLFWwindow* window);  // NOLINT(bugprone-reserved-identifier): the linker's own name
void __wrap_glfwSwapBuffers(GLFWwindow* window)   // NOLINT(bugprone-reserved-identifier)
{
    Play& now = play();
    if (!now.begun) {
        now.begun = true;
        now.failed = !take_the_keyboard(window);
    }
    print_frame(std::to_string(now.next));
    __real_glfwSwapBuffers(window);
    if (now.failed || now.next == lab4_keys.size()) {
        glfwSetWindowShouldClose(window, GLFW_TRUE);
        return glfwPostEmptyEvent();  // the program may be about to wait
    }
    const std::string key = std::to_string(glfwGetKeyScancode(lab4_keys[now.next++]));
    now.failed = !xdotool({"keydown", key});
    deliver(window);
    now.failed = !xdotool({"keyup", key}) || now.failed;
}
}

int main()
{
    run_lab4(lab_files(), play().earlier);
    if (play().failed) (void)std::fprintf(stderr, "xdotool could not press a key\n");
    return play().failed ? 1 : 0;
}
