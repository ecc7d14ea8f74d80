#include "attack/verdict_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbral::grader::attack {
namespace {

/// Text for a cell: no bar ends it early.
std::string cell(std::string text)
{
    std::ranges::replace(text, '|', '/');
    std::ranges::replace(text, '\n', ' ');
    return text;
}

}

std::string markdown(std::span<const Attack> attacks, const std::map<std::string, Rehearsal>& rehearsals)
{
    std::string text = "| attack | what it does |";
    std::string rule = "|---|---|";
    std::string sums = "| held | |";
    for (const auto& [setting, rehearsal] : rehearsals) {
        text += fmt::format(" {} |", setting);
        rule += "---|";
        const auto held = std::ranges::count_if(rehearsal.outcomes, [](const auto& one) { return one.second.findings.empty(); });
        sums += fmt::format(" {} of {} |", held, rehearsal.outcomes.size());
    }
    text += "\n" + rule + "\n";
    for (const Attack& attack : attacks) {
        text += fmt::format("| {}/{} | {} |", attack.theme, attack.name, cell(attack.what));
        for (const auto& [setting, rehearsal] : rehearsals) {
            const auto found = rehearsal.outcomes.find(attack.id());
            if (found == rehearsal.outcomes.end())
                text += " |";
            else
                text += fmt::format(" {}{} |", found->second.findings.empty() ? "" : "**did not hold:** ", cell(found->second.came));
        }
        text += "\n";
    }
    return text + sums + "\n";
}

}
