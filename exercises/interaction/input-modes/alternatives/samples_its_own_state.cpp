// alternative: the state is kept by the callbacks alone, and sampling copies it; requests count the wanted kind
#include <umbral/interaction/input_modes.hpp>

namespace umbral::interaction {

namespace {

class Source {
public:
    explicit Source(GLFWwindow* window) : window_(window), memory_(*(InputMemory*)glfwGetWindowUserPointer(window)) {}

    void begin()
    {
        double x, y;
        glfwGetCursorPos(window_, &x, &y);
        memory_.state.cursor = {x, y};
        memory_.state.buttons = 0;
        for (unsigned b = 0; b < 8; b++)
            if (glfwGetMouseButton(window_, int(b))) memory_.state.buttons += 1u << b;
        memory_.pending.clear();
    }

    void button(int b, bool down)
    {
        if (bool(memory_.state.buttons >> b & 1) != down) memory_.state.buttons ^= 1u << b;
        report(down ? InputKind::button_pressed : InputKind::button_released, b, {});
    }
    void move(glm::dvec2 to)
    {
        const glm::dvec2 from = memory_.state.cursor;
        memory_.state.cursor = to;
        report(InputKind::cursor_moved, 0, to - from);
    }
    void report(InputKind kind, int code, glm::dvec2 change)
    {
        InputEvent event;
        event.kind = kind;
        event.code = code;
        event.time = glfwGetTime();
        event.change = change;
        event.after = memory_.state;
        memory_.pending.push_back(event);
        if (memory_.requested && *memory_.requested == kind) {
            memory_.answer = event;
            memory_.requested = std::nullopt;  // whoever comes later is too late
        }
    }

private:
    GLFWwindow* window_;
    InputMemory& memory_;
};

void buttons(GLFWwindow* w, int b, int action, int) { Source(w).button(b, action == GLFW_PRESS); }
void cursor(GLFWwindow* w, double x, double y) { Source(w).move({x, y}); }
void wheel(GLFWwindow* w, double x, double y) { Source(w).report(InputKind::scrolled, 0, {x, y}); }
void keys(GLFWwindow* w, int key, int, int action, int)
{
    switch (action) {
        case GLFW_PRESS: Source(w).report(InputKind::key_pressed, key, {}); break;
        case GLFW_RELEASE: Source(w).report(InputKind::key_released, key, {}); break;
        default: break;
    }
}

}

void install_input(GLFWwindow* window)
{
    Source(window).begin();
    glfwSetKeyCallback(window, keys);
    glfwSetScrollCallback(window, wheel);
    glfwSetCursorPosCallback(window, cursor);
    glfwSetMouseButtonCallback(window, buttons);
}

MouseState sample_mouse(GLFWwindow* window)
{
    return static_cast<const InputMemory*>(glfwGetWindowUserPointer(window))->state;
}

std::optional<InputEvent> request_event(GLFWwindow* window, InputKind kind)
{
    auto& memory = *static_cast<InputMemory*>(glfwGetWindowUserPointer(window));
    glfwPollEvents();
    memory.answer = std::nullopt;
    memory.requested = kind;
    while (memory.requested) {
        if (glfwWindowShouldClose(window)) break;
        glfwWaitEvents();
    }
    memory.requested = std::nullopt;
    return memory.answer;
}

std::optional<InputEvent> next_event(GLFWwindow* window)
{
    auto& queue = static_cast<InputMemory*>(glfwGetWindowUserPointer(window))->pending;
    if (queue.size() == 0) return std::nullopt;
    InputEvent event = std::move(queue[0]);
    queue.pop_front();
    return event;
}

}
