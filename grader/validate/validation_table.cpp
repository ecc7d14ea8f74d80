#include "validate/validation_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace umbral::grader {
namespace {

/// One subject over all seeds.
struct Row {
    const Finding* first = nullptr;
    double least = 100;
    double most = 0;
    std::optional<double> hard;  ///< the least
    bool holds = true;
    std::set<std::string> blind;  ///< checks whose picture was the expected one, with every seed
};

using Rows = std::map<std::string, Row>;  // by subject

std::map<std::string, Rows> by_unit(std::span<const Finding> findings)
{
    std::map<std::string, Rows> units;
    for (const Finding& finding : findings) {
        Row& row = units[finding.unit][finding.subject];
        if (row.first == nullptr) row.first = &finding;
        row.least = std::min(row.least, finding.credit);
        row.most = std::max(row.most, finding.credit);
        if (finding.hard_share) row.hard = std::min(*finding.hard_share, row.hard.value_or(100));
        row.holds = row.holds && finding.holds;
        if (row.first == &finding) row.blind = {finding.blind.begin(), finding.blind.end()};
        std::erase_if(row.blind, [&](const std::string& check) {
            return std::ranges::find(finding.blind, check) == finding.blind.end();
        });
    }
    return units;
}

/// Text in a cell: a bar would end it.
std::string cell(std::string_view text)
{
    std::string result;
    for (const char c : text) {
        if (c == '|') result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

std::string percents(const Row& row)
{
    return row.most - row.least < 0.05 ? fmt::format("{:.1f}", row.least)
                                       : fmt::format("{:.1f} to {:.1f}", row.least, row.most);
}

std::string table_of(const Rows& rows)
{
    const bool has_hard = std::ranges::any_of(rows, [](const auto& entry) { return entry.second.hard.has_value(); });
    std::string text = has_hard
                           ? "| mistake | what is wrong | credit, % | hard cases, % | told |\n|---|---|---|---|---|\n"
                           : "| mistake | what is wrong | credit, % | told |\n|---|---|---|---|\n";
    for (const auto& [subject, row] : rows) {
        const auto colon = subject.find(": ");
        const bool is_mistake = subject.starts_with("mistake");
        if (!is_mistake && subject != "reference") continue;
        text += fmt::format("| {} | {} | {} |", is_mistake ? subject.substr(colon + 2) : "*reference*",
                            cell(row.first->what), percents(row));
        if (has_hard) text += row.hard ? fmt::format(" {:.0f} |", *row.hard) : " |";
        text += fmt::format(" {}{} |\n", cell(row.first->hint), row.holds ? "" : " **not as it should be**");
    }
    return text;
}

/// Which scenes cannot show which mistakes: their pictures come out equal.
std::string blind_lines(const Rows& rows)
{
    std::map<std::string, std::vector<std::string>> mistakes;  // by check
    for (const auto& [subject, row] : rows)
        for (const std::string& check : row.blind) mistakes[check].push_back(subject.substr(subject.find(": ") + 2));
    std::string text;
    for (const auto& [check, names] : mistakes)
        text += fmt::format("\nThe picture of `{}` cannot show: {}.\n", check, fmt::join(names, ", "));
    return text;
}

}

std::string validation_table(std::span<const Finding> findings, std::span<const Exercise> exercises)
{
    const auto units = by_unit(findings);
    std::string text =
        "# What each mistake gets\n\n"
        "Made by `umbral validate --table docs/mistakes.md`, with at least one seed. Credit is a share of the unit's "
        "points, from the\n"
        "lowest to the highest over the seeds; \"hard cases\" is the share of the points of the checks that are judged "
        "against the\n"
        "oracle. Where a scene cannot show a mistake, so that its picture equals the expected one bit by bit, a line "
        "below the\n"
        "table says so; other checks then tell.\n";
    for (const Exercise& exercise : exercises) {
        const auto found = units.find(exercise.id);
        if (found == units.end()) continue;
        const auto title = exercise.title.find("en");
        text += fmt::format("\n## {}\n{}\n\n{}", exercise.id, title == exercise.title.end() ? "" : title->second,
                            table_of(found->second));
        text += blind_lines(found->second);
    }
    return text;
}

}
