// play-headless-glfw MODE SCRIPT: plays an event script to headless GLFW and prints what came of it.

#include <umbral/input/headless.hpp>

#include "play.hpp"

int main(int, char** arguments)
try {
    using namespace umbral::input;
    const Headless session(read_script(arguments[2]));
    glfwInit();
    Printer printer(glfwCreateWindow(640, 480, "Umbral", nullptr, nullptr), arguments[1]);
    while (!session.script_is_over()) {
        glfwWaitEvents();
        printer.look();
    }
    printer.finish();
    return 0;
} catch (const std::exception& error) {
    (void)std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
