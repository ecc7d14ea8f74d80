#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <umbral/input/script.hpp>

/// A script as questions tell it.
namespace umbral::interaction {

/// What happened until a moment, a line for each event, without a line break at the end: all of it if `in_full`, else
/// the last eight events.
inline std::string script_until(const input::EventScript& script, double until, bool in_full)
{
    constexpr std::ptrdiff_t most_lines = 8;
    const auto end = std::ranges::find_if(script, [&](const input::TimedEvent& event) { return event.time > until; });
    const std::ptrdiff_t left_out = in_full ? 0 : std::max<std::ptrdiff_t>(end - script.begin() - most_lines, 0);
    std::string text = left_out > 0 ? "// … " + std::to_string(left_out) + " events left out\n" : "";
    text += input::to_text(input::EventScript(script.begin() + left_out, end));
    while (text.ends_with('\n')) text.pop_back();
    return text;
}

/// The same of a moment before, which the question is about, and how much happened since.
inline std::string script_about(const input::EventScript& script, double moment, double until, bool in_full)
{
    if (in_full || moment >= until) return script_until(script, until, in_full);
    const auto later = std::ranges::count_if(
        script, [&](const input::TimedEvent& event) { return event.time > moment && event.time <= until; });
    std::string text = script_until(script, moment, false);
    if (later > 0) text += "\n// … " + std::to_string(later) + " later events left out";
    return text;
}

}
