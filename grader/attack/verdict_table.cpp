#include "attack/verdict_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

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
    std::string text = "| setting | attacks that held | seconds | grader's MiB |\n|---|---|---|---|\n";
    for (const auto& [setting, rehearsal] : rehearsals) {
        const auto held =
            std::ranges::count_if(rehearsal.outcomes, [](const auto& one) { return one.second.findings.empty(); });
        text += fmt::format("| {} | {} of {} | {:.0f} | {:.0f} |\n", setting, held, rehearsal.outcomes.size(),
                            rehearsal.run.seconds, rehearsal.run.peak_mib);
    }
    text += "\n| attack | what it does | what came of it | in settings |\n|---|---|---|---|\n";
    for (const Attack& attack : attacks) {
        // Mostly the same comes of it everywhere, and is said once.
        std::map<std::string, std::vector<std::string>> settings;
        for (const auto& [setting, rehearsal] : rehearsals)
            if (const auto found = rehearsal.outcomes.find(attack.id()); found != rehearsal.outcomes.end())
                settings[(found->second.findings.empty() ? "" : "**did not hold:** ") + cell(found->second.came)]
                    .push_back(setting);
        for (const auto& [came, where] : settings)
            text += fmt::format(
                "| {}/{} | {} | {} | {} |\n", attack.theme, attack.name, cell(attack.what), came,
                settings.size() == 1 ? fmt::format("{}", where.size()) : fmt::format("{}", fmt::join(where, "; ")));
    }
    return text;
}

}
