#include <array>
#include <cmath>
#include <umbral/input/glfw.hpp>
#include <umbral/input/random_script.hpp>

namespace umbral::input {
namespace {

constexpr std::array modifiers = {GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_LEFT_ALT,
                                  GLFW_KEY_LEFT_SUPER};
constexpr std::array keys = {GLFW_KEY_R, GLFW_KEY_1,     GLFW_KEY_2,  GLFW_KEY_3, GLFW_KEY_4,
                             GLFW_KEY_A, GLFW_KEY_SPACE, GLFW_KEY_UP, GLFW_KEY_F5};

/// Draws one gesture after another onto a script. Numbers come from `random` only, in an order that depends on nothing
/// else.
class Session {
public:
    Session(Random& random, const RandomScriptSettings& settings)
        : random_(random), settings_(settings), size_(settings.window), place_(somewhere())
    {
    }

    EventScript record()
    {
        for (int i = 0; i < settings_.gestures; ++i) {
            switch (random_.below(10)) {
                case 0:
                case 1:
                case 2:
                case 3: drag(); break;
                case 4:
                case 5: wheel(); break;
                case 6:
                case 7: keyboard(); break;
                case 8: wander(); break;
                default: window();
            }
        }
        happens(Close{});
        return std::move(script_);
    }

private:
    bool chance(std::uint32_t one_in) { return random_.below(one_in) == 0; }

    double on_grid(double value, double cells) const
    {
        return settings_.fractions ? std::floor(value * cells) / cells : std::floor(value);
    }

    void happens(const Event& event)
    {
        time_ += 1 + random_.below(40);
        script_.push_back({1e-3 * static_cast<double>(time_), event});
    }

    glm::dvec2 somewhere()
    {
        const double x = on_grid(random_.uniform_double() * size_.x, 64);
        return {x, on_grid(random_.uniform_double() * size_.y, 64)};
    }

    /// A step of up to `reach` in each coordinate.
    void move(double reach)
    {
        const double x = on_grid((2 * random_.uniform_double() - 1) * reach, 64);
        place_ += glm::dvec2(x, on_grid((2 * random_.uniform_double() - 1) * reach, 64));
        happens(CursorMove{place_});
    }

    void wander()
    {
        place_ = somewhere();
        happens(CursorMove{place_});
        move(30);
    }

    void button(int which, bool pressed)
    {
        if (chance(3)) {  // a press is often where the pointer was seen last, but not always
            place_ += glm::dvec2(on_grid(random_.uniform_double() * 9, 64), 1);
            happens(MouseButton{which, pressed, true, place_});
        } else {
            happens(MouseButton{which, pressed});
        }
    }

    void drag()
    {
        constexpr std::array buttons = {GLFW_MOUSE_BUTTON_LEFT, GLFW_MOUSE_BUTTON_LEFT, GLFW_MOUSE_BUTTON_RIGHT,
                                        GLFW_MOUSE_BUTTON_RIGHT, GLFW_MOUSE_BUTTON_MIDDLE};
        place_ = somewhere();
        happens(CursorMove{place_});
        const int main = buttons[random_.below(buttons.size())];
        const int modifier = modifiers[random_.below(modifiers.size())];
        const bool modified = chance(3);
        if (modified) happens(Key{modifier, Key::Action::press});
        button(main, true);
        // The modifier counts where the button goes down: letting go of it later changes nothing.
        const bool early = modified && chance(2);
        if (early) happens(Key{modifier, Key::Action::release});
        const std::uint32_t steps = random_.below(6);
        const int second = (main + 1 + static_cast<int>(random_.below(2))) % 3;
        const std::uint32_t second_at = chance(3) ? random_.below(6) : 99;
        const bool first_up_first = chance(2);
        const double reach = chance(4) ? 900 : 40;  // a drag may leave the window
        for (std::uint32_t step = 0; step < steps; ++step) {
            if (step == second_at) button(second, true);
            move(reach);
            if (step == second_at && !first_up_first) button(second, false);
        }
        if (settings_.focus_losses && chance(8)) {
            happens(Focus{false});
            move(20);
            happens(Focus{true});
            move(20);
            return;  // the window saw everything released
        }
        button(main, false);
        if (second_at < steps && first_up_first) {
            move(20);
            button(second, false);
        }
        if (modified && !early) happens(Key{modifier, Key::Action::release});
        if (chance(2)) move(20);
    }

    void wheel()
    {
        for (std::uint32_t turns = 1 + random_.below(4); turns > 0; --turns) {
            const bool touchpad = settings_.fractions && chance(2);
            const double size = touchpad ? (1 + random_.below(24)) / 16.0 : 1.0 + random_.below(2);
            const double offset = chance(2) ? size : -size;
            const double aside = touchpad ? (static_cast<double>(random_.below(17)) - 8) / 16.0 : 0;
            happens(chance(5) ? Scroll{{offset, 0}} : Scroll{{aside, offset}});
        }
    }

    void keyboard()
    {
        const int key = keys[random_.below(keys.size())];
        const int modifier = modifiers[random_.below(modifiers.size())];
        const bool modified = chance(3);
        if (modified) happens(Key{modifier, Key::Action::press});
        happens(Key{key, Key::Action::press});
        for (std::uint32_t repeats = chance(3) ? random_.below(4) : 0; repeats > 0; --repeats)
            happens(Key{key, Key::Action::repeat});
        happens(Key{key, Key::Action::release});
        if (modified) happens(Key{modifier, Key::Action::release});
    }

    void window()
    {
        if (!settings_.resizes) return wander();
        if (chance(3)) happens(Resize{{0, chance(2) ? 0 : size_.y}});
        size_ = {200 + static_cast<int>(random_.below(1200)), 150 + static_cast<int>(random_.below(800))};
        happens(Resize{size_});
    }

    Random& random_;
    RandomScriptSettings settings_;
    glm::ivec2 size_;
    glm::dvec2 place_{0};
    std::uint64_t time_ = 0;  ///< milliseconds
    EventScript script_;
};

}

EventScript random_script(Random& random, const RandomScriptSettings& settings)
{
    return Session(random, settings).record();
}

}
