#pragma once

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <umbral/core/random.hpp>
#include <umbral/input/events.hpp>
#include <umbral/input/glfw.hpp>
#include <umbral/input/names.hpp>
#include <utility>

/// Users who do anything at any moment: no gesture ends before another one begins.
namespace umbral::interaction {

/// Draws one event after another, whatever is held at that moment. Places are multiples of 1/128, so that differences
/// are exact in float; no motion is null.
class Walk {
public:
    explicit Walk(Random& random) : random_(random) {}

    input::EventScript record(int events)
    {
        while (static_cast<int>(script_.size()) < events) {
            switch (random_.below(16)) {
                case 0:
                case 1:
                case 2:
                case 3: button(); break;
                case 4: wheel(); break;
                case 5:
                case 6: key(one_of(keys)); break;
                case 7: modifier(); break;
                case 8:
                case 9: window(); break;
                default: move();
            }
        }
        return std::move(script_);
    }

private:
    static constexpr std::array buttons = {0, 0, 0, 0, 1, 1, 1, 2, 3, 7};
    static constexpr std::array keys = {GLFW_KEY_R, GLFW_KEY_R, GLFW_KEY_R, GLFW_KEY_1, GLFW_KEY_2,    GLFW_KEY_3,
                                        GLFW_KEY_0, GLFW_KEY_4, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_KP_2, GLFW_KEY_ESCAPE};
    static constexpr std::array modifiers = {GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT,   GLFW_KEY_LEFT_CONTROL,
                                             GLFW_KEY_LEFT_ALT,   GLFW_KEY_RIGHT_CONTROL, GLFW_KEY_LEFT_SUPER};

    template <std::size_t N>
    int one_of(const std::array<int, N>& list)
    {
        return list[random_.below(static_cast<std::uint32_t>(N))];
    }
    bool chance(std::uint32_t one_in) { return random_.below(one_in) == 0; }
    double sign() { return chance(2) ? 1 : -1; }

    void happens(const input::Event& event, bool at_once = false)
    {
        if (!at_once) time_ += 1 + random_.below(40);
        script_.push_back({1e-3 * static_cast<double>(time_), event});
    }

    /// From the smallest step to some hundred pixels, straight or aslant; from far outside back to the middle.
    glm::dvec2 step()
    {
        const double size = std::floor(std::exp2(random_.uniform(0, 15.5F))) / 128;
        const double other = chance(2) ? 0 : sign() * std::floor(std::exp2(random_.uniform(0, 15.5F))) / 128;
        const glm::dvec2 step = chance(2) ? glm::dvec2(sign() * size, other) : glm::dvec2(other, sign() * size);
        return {place_.x * step.x > 9e4 ? -step.x : step.x, place_.y * step.y > 9e4 ? -step.y : step.y};
    }
    void move()
    {
        place_ += step();
        happens(input::CursorMove{place_});
    }

    void button()
    {
        const int which = one_of(buttons);
        const bool pressed = held_buttons_.erase(which) == 0;
        if (pressed) held_buttons_.insert(which);
        const bool placed = chance(3);
        if (placed) place_ += step();
        happens(placed ? input::MouseButton{which, pressed, true, place_} : input::MouseButton{which, pressed});
        // What the press began is soon seen, whatever comes after.
        if (pressed && chance(2)) move();
    }

    void wheel()
    {
        const double y = chance(5) ? 0 : sign() * std::exp2(random_.uniform(-14, 4));
        happens(input::Scroll{{y == 0 || chance(2) ? sign() * std::exp2(random_.uniform(-14, 4)) : 0, y}});
        if (chance(2)) move();
    }

    /// What is held goes up, or is repeated first. Escape comes twice at once, too.
    void key(int which)
    {
        const bool goes_up = held_keys_.contains(which);
        if (goes_up && chance(3)) return happens(input::Key{which, input::Key::Action::repeat});
        happens(input::Key{which, goes_up ? input::Key::Action::release : input::Key::Action::press});
        if (goes_up) {
            held_keys_.erase(which);
        } else if (which == GLFW_KEY_ESCAPE && chance(2)) {
            happens(input::Key{which, input::Key::Action::release}, true);
            happens(input::Key{which, input::Key::Action::press}, true);
            happens(input::Key{which, input::Key::Action::release});
        } else {
            held_keys_.insert(which);
        }
        if (chance(2)) move();
    }

    /// Mostly none is held.
    void modifier()
    {
        const bool goes_up = held_modifier_ != 0 && !chance(4);
        const int which = goes_up ? held_modifier_ : one_of(modifiers);
        held_modifier_ = goes_up ? 0 : which;
        happens(input::Key{which, goes_up ? input::Key::Action::release : input::Key::Action::press});
        if (chance(2)) button();
    }

    void window()
    {
        switch (random_.below(8)) {
            case 0:
            case 1: {
                const std::uint32_t width = chance(3) ? 1 : 1 + random_.below(1200);
                happens(input::Resize{{width, chance(3) ? 1 : 1 + random_.below(900)}});
                break;
            }
            case 2: happens(input::Resize{{0, chance(2) ? 0 : 300}}); break;
            case 3: happens(input::CursorEnter{(entered_ = !entered_)}); break;
            case 4: happens(input::Iconify{(iconified_ = !iconified_)}); break;
            case 5: happens(input::Refresh{}); break;
            case 6: happens(input::Close{}); break;
            default:
                // The window sees everything released.
                held_buttons_.clear();
                held_keys_.clear();
                held_modifier_ = 0;
                happens(input::Focus{false});
                if (chance(2)) move();
                happens(input::Focus{true});
        }
        move();
    }

    Random& random_;
    std::set<int> held_buttons_;
    std::set<int> held_keys_;
    int held_modifier_ = 0;  ///< the last one; others may be
    bool entered_ = true;
    bool iconified_ = false;
    glm::dvec2 place_{0};
    std::uint64_t time_ = 0;  ///< milliseconds
    input::EventScript script_;
};

/// A key event as GLFW may give it on any keyboard.
struct AnyKey {
    int key;
    int scancode;
    int action;
    int mods;
};

/// Known keys and others, with codes of no keyboard in particular; Caps Lock and Num Lock may be among the modifiers.
inline AnyKey any_key(Random& random)
{
    constexpr std::array meant = {GLFW_KEY_UNKNOWN, GLFW_KEY_R, GLFW_KEY_1, GLFW_KEY_2, GLFW_KEY_3, GLFW_KEY_ESCAPE};
    const std::uint32_t which = random.below(10);
    const int other = GLFW_KEY_A + static_cast<int>(random.below(26));
    AnyKey drawn{which < meant.size() ? meant[which] : other, static_cast<int>(random.below(512)), 0, 0};
    constexpr std::array actions = {GLFW_PRESS, GLFW_PRESS, GLFW_REPEAT, GLFW_RELEASE};
    drawn.action = actions[random.below(actions.size())];
    drawn.mods = (random.below(2) != 0 ? GLFW_MOD_CAPS_LOCK : 0) | (random.below(2) != 0 ? GLFW_MOD_NUM_LOCK : 0);
    return drawn;
}

/// The call that tells a window's key callback of it.
inline std::string told(const AnyKey& event)
{
    constexpr std::array actions = {"GLFW_RELEASE", "GLFW_PRESS", "GLFW_REPEAT"};
    std::string mods;
    if ((event.mods & GLFW_MOD_CAPS_LOCK) != 0) mods = "GLFW_MOD_CAPS_LOCK";
    if ((event.mods & GLFW_MOD_NUM_LOCK) != 0) mods += std::string(mods.empty() ? "" : " | ") + "GLFW_MOD_NUM_LOCK";
    return "on_key(window, GLFW_KEY_" + (event.key < 0 ? "UNKNOWN" : input::name_of_key(event.key)) + ", " +
           std::to_string(event.scancode) + ", " + actions[static_cast<std::size_t>(event.action)] + ", " +
           (mods.empty() ? "0" : mods) + ");";
}

}
