#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <umbral/input/script.hpp>
#include <umbral/record/variation.hpp>
#include <variant>
#include <vector>

/// Scripts that are written down, varied: what happens stays what it is, in its order.
namespace umbral::interaction {

/// Which of a script's numbers may be others than written.
struct ScriptNumbers {
    bool places = true;    ///< of the pointer: farther from the window's upper left corner, or nearer, never across it
    bool steps = true;     ///< of the wheel: larger or smaller
    bool sizes = true;     ///< of the window, where it is larger than a pixel
    bool times = false;    ///< all of the script: sooner or later
    bool buttons = false;  ///< the left, right and middle button, each in another's place
};

/// The script with its numbers multiplied by 3/4, 5/4 or 3/2: those of a kind by the same, so that what is equal, small
/// or outside remains so. As written unless inputs are to vary.
inline input::EventScript varied(Variation& vary, input::EventScript script, const ScriptNumbers& numbers = {})
{
    constexpr std::array factors{0.75, 1.25, 1.5};
    const glm::dvec2 place(vary.one_of(1.0, factors), vary.one_of(1.0, factors));
    const double step = vary.one_of(1.0, factors);
    const double size = vary.one_of(1.0, factors);
    const double time = vary.one_of(1.0, factors);
    const int first_button = vary.one_of(0, std::array{1, 2});
    for (input::TimedEvent& event : script) {
        if (numbers.times) event.time *= time;
        if (numbers.places) {
            if (auto* const move = std::get_if<input::CursorMove>(&event.event)) move->place *= place;
            if (auto* const button = std::get_if<input::MouseButton>(&event.event)) button->place *= place;
        }
        if (auto* const button = std::get_if<input::MouseButton>(&event.event); button != nullptr && numbers.buttons)
            if (button->button < 3) button->button = (button->button + first_button) % 3;
        if (auto* const scroll = std::get_if<input::Scroll>(&event.event); scroll != nullptr && numbers.steps)
            scroll->offset *= step;
        if (auto* const resize = std::get_if<input::Resize>(&event.event); resize != nullptr && numbers.sizes)
            for (int i = 0; i < 2; ++i)
                if (int& length = resize->size[i]; length > 1) length = static_cast<int>(length * size);
    }
    return script;
}

inline input::EventScript varied(Variation& vary, std::string_view text, const ScriptNumbers& numbers = {})
{
    return varied(vary, input::parse_script(text), numbers);
}

/// The script with the pointer's places turned about a middle, by at most a radian. As written unless inputs are to
/// vary.
inline input::EventScript turned(Variation& vary, input::EventScript script, const glm::dvec2& middle)
{
    const glm::dmat2 turn(glm::mat2(vary.turn({0, 0, 1}, 1)));
    const auto turn_place = [&](glm::dvec2& place) { place = middle + turn * (place - middle); };
    if (!vary) return script;
    for (input::TimedEvent& event : script) {
        if (auto* const move = std::get_if<input::CursorMove>(&event.event)) turn_place(move->place);
        if (auto* const button = std::get_if<input::MouseButton>(&event.event)) turn_place(button->place);
    }
    return script;
}

/// The script behind ten to twenty keys that are pressed and released before its first event, of those given. As
/// written unless inputs are to vary.
inline input::EventScript behind_other_keys(Variation& vary, const input::EventScript& script,
                                            const std::vector<int>& keys)
{
    Random* const random = vary.random();
    if (random == nullptr) return script;
    input::EventScript all;
    const std::uint32_t count = 10 + random->below(11);
    for (std::uint32_t i = 0; i < count; ++i) {
        const int key = keys[random->below(static_cast<std::uint32_t>(keys.size()))];
        const double time = script.front().time * (i + 1) / (count + 1.0);
        all.push_back({time, input::Key{key, input::Key::Action::press}});
        all.push_back({time, input::Key{key, input::Key::Action::release}});
    }
    all.insert(all.end(), script.begin(), script.end());
    return all;
}

}
