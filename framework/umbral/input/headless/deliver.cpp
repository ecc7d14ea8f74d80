#include <umbral/input/names.hpp>

#include "state.hpp"

namespace umbral::input::headless {
namespace {

/// Calls a callback if there is one.
template <class Callback, class... Arguments>
void call(Callback callback, Arguments... arguments)
{
    if (callback != nullptr) callback(arguments...);
}

/// Puts a key or button into a new state. Released ones may stay to be asked for.
void set(int& held, int action, bool sticky) { held = action == GLFW_RELEASE && sticky ? stuck : action; }

void input_button(GLFWwindow& window, int button, int action, int mods)
{
    set(window.buttons.at(static_cast<std::size_t>(button)), action,
        window.input_modes[GLFW_STICKY_MOUSE_BUTTONS] != 0);
    call(window.callbacks.mouse_button, &window, button, action, mods);
}

void input_key(GLFWwindow& window, int key, int action, int mods)
{
    int& held = window.keys.at(static_cast<std::size_t>(key));
    if (action == GLFW_RELEASE && held == GLFW_RELEASE) return;
    const bool repeated = action != GLFW_RELEASE && held == GLFW_PRESS;
    set(held, action == GLFW_RELEASE ? GLFW_RELEASE : GLFW_PRESS, window.input_modes[GLFW_STICKY_KEYS] != 0);
    call(window.callbacks.key, &window, key, key, repeated ? GLFW_REPEAT : action, mods);
}

void input_character(GLFWwindow& window, char32_t code_point, int mods)
{
    call(window.callbacks.character_mods, &window, static_cast<unsigned>(code_point), mods);
    if ((mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT)) == 0)
        call(window.callbacks.character, &window, static_cast<unsigned>(code_point));
}

/// One overload for each event.
struct Delivery {
    GLFWwindow& window;

    void operator()(const CursorMove& event) const
    {
        if (event.place == window.cursor) return;
        window.cursor = event.place;
        call(window.callbacks.cursor_position, &window, event.place.x, event.place.y);
    }

    void operator()(const MouseButton& event) const
    {
        if (event.placed) (*this)(CursorMove{event.place});
        input_button(window, event.button, event.pressed ? GLFW_PRESS : GLFW_RELEASE, held_modifiers(window));
    }

    void operator()(const Scroll& event) const
    {
        call(window.callbacks.scroll, &window, event.offset.x, event.offset.y);
    }

    void operator()(const Key& event) const
    {
        if (window.attributes[GLFW_FOCUSED] == 0) return;
        const int mods = held_modifiers(window);
        input_key(window, event.key, static_cast<int>(event.action), mods);
        if (event.action == Key::Action::release) return;
        if (const char typed = character_of(event.key, (mods & GLFW_MOD_SHIFT) != 0))
            input_character(window, static_cast<char32_t>(typed), mods);
    }

    void operator()(const Character& event) const
    {
        if (window.attributes[GLFW_FOCUSED] != 0) input_character(window, event.code_point, 0);
    }

    void operator()(const Resize& event) const
    {
        if (event.size == window.size) return;
        window.size = event.size;
        const glm::ivec2 pixels = framebuffer_size(window);
        call(window.callbacks.framebuffer_size, &window, pixels.x, pixels.y);
        call(window.callbacks.size, &window, window.size.x, window.size.y);
    }

    void operator()(const Focus& event) const
    {
        int& focused = window.attributes[GLFW_FOCUSED];
        if (focused == static_cast<int>(event.gained)) return;
        focused = static_cast<int>(event.gained);
        call(window.callbacks.focus, &window, focused);
        if (event.gained) return;
        for (int key = 0; key <= GLFW_KEY_LAST; ++key)
            if (window.keys.at(static_cast<std::size_t>(key)) == GLFW_PRESS) input_key(window, key, GLFW_RELEASE, 0);
        for (int button = 0; button <= GLFW_MOUSE_BUTTON_LAST; ++button)
            if (window.buttons.at(static_cast<std::size_t>(button)) == GLFW_PRESS)
                input_button(window, button, GLFW_RELEASE, 0);
    }

    void operator()(const CursorEnter& event) const
    {
        window.attributes[GLFW_HOVERED] = static_cast<int>(event.entered);
        call(window.callbacks.cursor_enter, &window, static_cast<int>(event.entered));
    }

    void operator()(const Iconify& event) const
    {
        int& iconified = window.attributes[GLFW_ICONIFIED];
        if (iconified == static_cast<int>(event.iconified)) return;
        iconified = static_cast<int>(event.iconified);
        call(window.callbacks.iconify, &window, iconified);
    }

    void operator()(const Refresh&) const { call(window.callbacks.refresh, &window); }

    void operator()(const Close&) const
    {
        window.should_close = true;
        call(window.callbacks.close, &window);
    }
};

}

void deliver(GLFWwindow& window, const Event& event) { std::visit(Delivery{window}, event); }

}
