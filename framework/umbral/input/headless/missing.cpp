#include "state.hpp"

namespace umbral::input::headless {

[[noreturn]] void missing(const char* function);

void missing(const char* function)
{
    give_up(std::string(function) +
            ": headless GLFW does not have this; it has the window, its callbacks, mouse, keyboard, time, and the "
            "event loop. Leave the call out of this unit");
}

}
