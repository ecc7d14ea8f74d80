#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <string_view>
#include <umbral/input/events.hpp>
#include <umbral/input/glfw.hpp>
#include <umbral/record/ask_inputs.hpp>
#include <vector>

/// Event scripts as questions: what they are made of can be left out, and it is known what happened before an answer.
namespace umbral {
namespace detail {

template <class... Kinds>
bool is_event_of(const input::TimedEvent& event)
{
    return (std::holds_alternative<Kinds>(event.event) || ...);
}

inline bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

inline bool is_of_modifier(const input::TimedEvent& event)
{
    const auto* const key = std::get_if<input::Key>(&event.event);
    return key != nullptr && is_modifier(key->key);
}

inline bool is_repeat(const input::TimedEvent& event)
{
    const auto* const key = std::get_if<input::Key>(&event.event);
    return key != nullptr && key->action == input::Key::Action::repeat;
}

/// A script without the events for which `is_meant` says so.
template <class IsMeant>
constexpr Change without_events(std::string_view name, IsMeant /*unused*/)
{
    return change<input::EventScript>(name, [](input::EventScript& script) { std::erase_if(script, IsMeant{}); });
}

template <>
struct ChangesOf<input::EventScript> {
    static constexpr std::array all{
        without_events("without movements of the pointer",
                       [](const auto& event) { return is_event_of<input::CursorMove>(event); }),
        without_events("without presses and releases of buttons",
                       [](const auto& event) { return is_event_of<input::MouseButton>(event); }),
        without_events("without scrolling", [](const auto& event) { return is_event_of<input::Scroll>(event); }),
        without_events("without Shift, Control, Alt and Super",
                       [](const auto& event) { return is_of_modifier(event); }),
        without_events("without repeats of keys", [](const auto& event) { return is_repeat(event); }),
        without_events("without keys", [](const auto& event) { return is_event_of<input::Key>(event); }),
        without_events("without new sizes of the window",
                       [](const auto& event) { return is_event_of<input::Resize>(event); }),
        without_events("without changes of the focus",
                       [](const auto& event) { return is_event_of<input::Focus>(event); }),
        without_events("without the pointer entering or leaving",
                       [](const auto& event) { return is_event_of<input::CursorEnter>(event); }),
        without_events("without minimising", [](const auto& event) { return is_event_of<input::Iconify>(event); }),
        without_events("without refreshes", [](const auto& event) { return is_event_of<input::Refresh>(event); }),
        change<input::EventScript>("without parts of steps of the wheel",
                                   [](input::EventScript& script) {
                                       for (input::TimedEvent& event : script)
                                           if (auto* const scroll = std::get_if<input::Scroll>(&event.event))
                                               scroll->offset = glm::trunc(scroll->offset);
                                   }),
    };
};

/// What happened until a moment, and what is held then.
struct HappenedBefore {
    std::set<int> keys{};
    std::set<int> buttons{};
    std::array<double, std::variant_size_v<input::Event>> events{};  ///< of each kind

    explicit HappenedBefore(std::span<const input::TimedEvent> script)
    {
        for (const auto& [time, event] : script) {
            ++events.at(event.index());
            if (const auto* const button = std::get_if<input::MouseButton>(&event))
                hold(buttons, button->button, button->pressed);
            if (const auto* const key = std::get_if<input::Key>(&event))
                hold(keys, key->key, key->action != input::Key::Action::release);
            if (const auto* const focus = std::get_if<input::Focus>(&event); focus != nullptr && !focus->gained) {
                keys.clear();
                buttons.clear();
            }
        }
    }

    /// Of a modifier's two keys, how many are held.
    [[nodiscard]] double held(int left, int right) const
    {
        return static_cast<double>(keys.count(left) + keys.count(right));
    }

private:
    static void hold(std::set<int>& held, int which, bool down)
    {
        if (down)
            held.insert(which);
        else
            held.erase(which);
    }
};

/// What happened until the question, in numbers.
inline void add_events(const input::EventScript& script, Features& features)
{
    const HappenedBefore before(script);
    constexpr std::array<std::string_view, std::variant_size_v<input::Event>> kinds{
        "presses and releases of buttons",
        "movements of the pointer",
        "steps of the wheel",
        "keys",
        "characters",
        "new sizes of the window",
        "changes of the focus",
        "times that the pointer entered or left",
        "times that the window was minimised or restored",
        "refreshes",
        "requests to close"};
    for (std::size_t i = 0; i < kinds.size(); ++i)
        features.add(before.events[i], [&] { return "the number of " + std::string(kinds[i]) + " until then"; });
    const auto held = [&](std::string_view name, int left, int right) {
        features.add(before.held(left, right), [&] { return "the number of " + std::string(name) + " keys held"; });
    };
    held("Shift", GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    held("Control", GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    held("Alt", GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
    held("Super", GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
    features.add(static_cast<double>(before.buttons.size()), [] { return std::string("the number of buttons held"); });
}

/// A script as what can be misunderstood of a question.
inline Part part_of(input::EventScript& script)
{
    return {.place = Place{Place::no_argument} / "the script",
            .type = reflect::type_name<input::EventScript>(),
            .value = &script,
            .changes = ChangesOf<input::EventScript>::all,
            .exchange = exchange<input::EventScript>,
            .take = take<input::EventScript>};
}

}

/// A script that a session is asked with, played to `program`, as sentences call it: another one if another question is
/// asked in place of this one. Its questions begin with ask_in_script.
[[nodiscard]] inline input::EventScript script_asked(Recorder& out, std::string_view program, input::EventScript script)
{
    Questions* const questions = out.questions();
    if (questions != nullptr && questions->asks_instead_of(program)) {
        const Part whole = detail::part_of(script);
        questions->change(program, {&whole, 1});
    }
    return script;
}

/// ask_in_words of what `program` answered at a moment of its script. events() returns what happened until then; it is
/// called only if somebody wants it.
template <class Events, class Code>
void ask_in_script(Recorder& out, std::string_view program, const Events& events, const Code& code)
{
    ask_in_words(out, code);
    Questions* const questions = out.questions();
    if (questions == nullptr) return;
    input::EventScript before = events();
    const auto parts = [&] { return std::vector<Part>{detail::part_of(before)}; };
    detail::note(
        *questions, program, [&](Features& features) { detail::add_events(before, features); }, parts);
}

/// The events until a moment.
[[nodiscard]] inline input::EventScript events_until(const input::EventScript& script, double until)
{
    return {script.begin(), std::ranges::find_if(script, [&](const auto& event) { return event.time > until; })};
}

}
