#include <fmt/format.h>

#include <algorithm>

#include "judge/events/events.hpp"
#include "judge/evidence/kinds.hpp"

namespace umbral::grader {
namespace {

/// "zoom (2, 0.5)": the code's name, or the code, then the numbers.
std::vector<std::string> event_lines(const TensorView& view, const std::map<double, std::string>& names, bool& cut)
{
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < view.cells(); ++i) {
        if (lines.size() == most_compared_lines) {
            cut = true;
            break;
        }
        const auto event = view.cell(i);
        const auto name = names.find(event[0]);
        std::string text = name != names.end() ? name->second : fmt::format("event {}", number_text(event[0]));
        for (std::size_t k = 1; k < event.size(); ++k) text += (k == 1 ? " (" : ", ") + number_text(event[k]);
        lines.push_back(event.size() > 1 ? text + ")" : text);
    }
    return lines;
}

}

Evidence events_evidence(const Check& check, const Observation& observation, bool right)
{
    if (right) return {};
    bool cut = false;
    const TensorView yours(*observation.yours);
    const TensorView expected(*observation.expected);
    const auto names = event_names(text_of(observation.names));
    Sides sides{event_lines(yours, names, cut), event_lines(expected, names, cut), {}};
    if (yours.cells() > 0 && yours.components() != expected.components()) return {};
    sides.alignment = align_events(check, yours, expected);
    std::erase_if(sides.alignment.matches, [&](const auto& match) {
        return match.first >= sides.yours.size() || match.second >= sides.expected.size();
    });
    return lines_evidence(sides, "Events", cut);
}

}
