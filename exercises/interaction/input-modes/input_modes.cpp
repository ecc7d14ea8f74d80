#include <umbral/interaction/input_modes.hpp>

namespace umbral::interaction {

void install_input(GLFWwindow* window)
{
    // TODO: above this function, write callbacks for mouse buttons, cursor, scrolling and keys: each brings
    // InputMemory::state up to date and appends an InputEvent to InputMemory::pending. Register them here, and ask GLFW
    // what the state is at the beginning. Delete the next line.
    (void)not_implemented<int>(window);
}

MouseState sample_mouse(GLFWwindow* window)
{
    // TODO: the state after the last event delivered. Replace the next line.
    return not_implemented<MouseState>(window);
}

std::optional<InputEvent> request_event(GLFWwindow* window, InputKind kind)
{
    // TODO: poll once, then wait until an event of this kind has come, or the window is to close. Replace the next
    // line.
    return not_implemented<std::optional<InputEvent>>(window, kind);
}

std::optional<InputEvent> next_event(GLFWwindow* window)
{
    // TODO: take the oldest pending event. Replace the next line.
    return not_implemented<std::optional<InputEvent>>(window);
}

}
