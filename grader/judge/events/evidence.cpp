#include <algorithm>

#include "judge/events/events.hpp"
#include "judge/evidence/kinds.hpp"

namespace umbral::grader {
namespace {

std::vector<std::string> event_lines(const TensorView& view, const EventWriter& write, bool& cut)
{
    cut = cut || view.cells() > most_compared_lines;
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < std::min(view.cells(), most_compared_lines); ++i) lines.push_back(write(view.cell(i)));
    return lines;
}

}

Evidence events_evidence(const Check& check, const Observation& observation, bool right)
{
    if (right) return {};
    bool cut = false;
    const TensorView yours(*observation.yours);
    const TensorView expected(*observation.expected);
    if (yours.cells() > 0 && yours.components() != expected.components()) return {};
    const EventWriter write(expected, text_of(observation.names));
    Sides sides{event_lines(yours, write, cut), event_lines(expected, write, cut), {}, 0};
    sides.alignment = align_events(check, yours, expected);
    std::erase_if(sides.alignment.matches, [&](const auto& match) {
        return match.first >= sides.yours.size() || match.second >= sides.expected.size();
    });
    return lines_evidence(sides, "Events", cut);
}

}
