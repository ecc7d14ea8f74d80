// Based on: the course's three modes of input (muestreo, petición, cola de eventos), which go back to GKS and PHIGS:
// ISO 7942:1985, Graphical Kernel System, "input operating modes"; here over GLFW's callbacks.

#include <umbral/interaction/input_modes.hpp>

#include <utility>

namespace umbral::interaction {
namespace {

InputMemory& memory_of(GLFWwindow* window) { return *static_cast<InputMemory*>(glfwGetWindowUserPointer(window)); }

MouseState state_now(GLFWwindow* window)
{
    MouseState state;
    glfwGetCursorPos(window, &state.cursor.x, &state.cursor.y);
    for (int button = 0; button <= GLFW_MOUSE_BUTTON_LAST; ++button)
        if (glfwGetMouseButton(window, button) == GLFW_PRESS) state.buttons |= 1U << static_cast<unsigned>(button);
    return state;
}

/// Notes an event whose state has been reached.
void note(GLFWwindow* window, InputKind kind, int code, glm::dvec2 change = {0, 0})
{
    InputMemory& memory = memory_of(window);
    const InputEvent event{kind, code, glfwGetTime(), change, memory.state};
    memory.pending.push_back(event);
    if (memory.requested == kind && !memory.answer) memory.answer = event;
}

void on_button(GLFWwindow* window, int button, int action, int)
{
    unsigned& buttons = memory_of(window).state.buttons;
    const unsigned bit = 1U << static_cast<unsigned>(button);
    buttons = action == GLFW_PRESS ? buttons | bit : buttons & ~bit;
    note(window, action == GLFW_PRESS ? InputKind::button_pressed : InputKind::button_released, button);
}

void on_cursor(GLFWwindow* window, double x, double y)
{
    glm::dvec2& cursor = memory_of(window).state.cursor;
    const glm::dvec2 change = glm::dvec2(x, y) - cursor;
    cursor = {x, y};
    note(window, InputKind::cursor_moved, 0, change);
}

void on_scroll(GLFWwindow* window, double x, double y) { note(window, InputKind::scrolled, 0, {x, y}); }

void on_key(GLFWwindow* window, int key, int, int action, int)
{
    if (action == GLFW_PRESS) note(window, InputKind::key_pressed, key);
    if (action == GLFW_RELEASE) note(window, InputKind::key_released, key);
}

}

void install_input(GLFWwindow* window)
{
    // Later GLFW is not asked: a real pointer may be farther on by then than the last event that it has delivered.
    memory_of(window).state = state_now(window);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetCursorPosCallback(window, on_cursor);
    glfwSetScrollCallback(window, on_scroll);
    glfwSetKeyCallback(window, on_key);
}

MouseState sample_mouse(GLFWwindow* window) { return memory_of(window).state; }

std::optional<InputEvent> request_event(GLFWwindow* window, InputKind kind)
{
    InputMemory& memory = memory_of(window);
    glfwPollEvents();
    memory.requested = kind;
    while (!memory.answer && glfwWindowShouldClose(window) == GLFW_FALSE) glfwWaitEvents();
    memory.requested.reset();
    return std::exchange(memory.answer, std::nullopt);
}

std::optional<InputEvent> next_event(GLFWwindow* window)
{
    std::deque<InputEvent>& pending = memory_of(window).pending;
    if (pending.empty()) return std::nullopt;
    const InputEvent oldest = pending.front();
    pending.pop_front();
    return oldest;
}

}
