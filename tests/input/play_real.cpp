// play-real-glfw MODE SCRIPT: opens a window with the real GLFW, has xdotool do what an event script says, and prints
// what came of it.

#include "hands.hpp"
#include "play.hpp"

namespace umbral::input {
namespace {

void play(const char* mode, const char* script)
{
    GLFWwindow* window = open_window();
    Printer printer(window, mode);
    const Hands hands(window);
    for (const auto& [time, event] : read_script(script)) {
        std::visit(hands, event);
        deliver(window);
        printer.look();
    }
    printer.finish();
    glfwTerminate();
}

}
}

int main(int, char** arguments)
try {
    umbral::input::play(arguments[1], arguments[2]);
    return 0;
} catch (const std::exception& error) {
    (void)std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
