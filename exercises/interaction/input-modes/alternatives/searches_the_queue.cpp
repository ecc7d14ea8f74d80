// alternative: lambdas; the state of the mouse is GLFW's, and a request looks through the events that came behind it
#include <algorithm>
#include <umbral/interaction/input_modes.hpp>

namespace umbral::interaction {

static InputMemory* memory(GLFWwindow* w) { return static_cast<InputMemory*>(glfwGetWindowUserPointer(w)); }

static void push(GLFWwindow* w, InputEvent e)
{
    e.time = glfwGetTime();
    e.after = sample_mouse(w);
    memory(w)->pending.push_back(e);
}

void install_input(GLFWwindow* window)
{
    glfwGetCursorPos(window, &memory(window)->state.cursor.x, &memory(window)->state.cursor.y);
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        push(w,
             {.kind = action == GLFW_RELEASE ? InputKind::button_released : InputKind::button_pressed, .code = button});
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        glm::dvec2& last = memory(w)->state.cursor;
        push(w, {.kind = InputKind::cursor_moved, .change = glm::dvec2(x - last.x, y - last.y)});
        last = glm::dvec2(x, y);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        push(w, {.kind = InputKind::scrolled, .change = glm::dvec2(x, y)});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
        if (action == GLFW_REPEAT) return;
        push(w, {.kind = action ? InputKind::key_pressed : InputKind::key_released, .code = key});
    });
}

MouseState sample_mouse(GLFWwindow* window)
{
    MouseState state;
    glfwGetCursorPos(window, &state.cursor[0], &state.cursor[1]);
    for (int i = 7; i >= 0; --i) state.buttons = 2 * state.buttons + (glfwGetMouseButton(window, i) != GLFW_RELEASE);
    return state;
}

std::optional<InputEvent> request_event(GLFWwindow* window, InputKind kind)
{
    glfwPollEvents();
    const std::deque<InputEvent>& all = memory(window)->pending;
    const auto before = static_cast<std::ptrdiff_t>(all.size());
    for (;;) {
        const auto found =
            std::find_if(all.begin() + before, all.end(), [&](const InputEvent& e) { return e.kind == kind; });
        if (found != all.end()) return *found;
        if (glfwWindowShouldClose(window)) return {};
        glfwWaitEvents();
    }
}

std::optional<InputEvent> next_event(GLFWwindow* window)
{
    std::optional<InputEvent> event;
    if (auto& queue = memory(window)->pending; !queue.empty()) {
        event = queue.front();
        queue.erase(queue.begin());
    }
    return event;
}

}
