#include "mutants/mutants_table.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace umbral::grader {
namespace {

std::size_t equivalent(const UnitMutants& unit)
{
    return unit.mutants.size() - unit.killed() - unit.survivors().size();
}

/// Text within a cell of a table.
std::string in_cell(const std::string& text)
{
    std::string cell;
    for (const char c : text) cell += c == '|' ? std::string("\\|") : std::string(1, c);
    return cell;
}

std::string place(const UnitMutants& unit, const TriedMutant& one)
{
    return fmt::format("{}:{}", unit.file, one.mutant.line);
}

}

std::string mutants_text(const UnitMutants& unit)
{
    if (!unit.trouble.empty()) return fmt::format("{:<32} {}\n", unit.unit, unit.trouble);
    const std::size_t alive = unit.survivors().size();
    std::string text = fmt::format("{:<32} {:4} mutants, {:4} killed, {:3} equivalent, {:3} survive\n", unit.unit,
                                   unit.mutants.size(), unit.killed(), equivalent(unit), alive);
    for (const TriedMutant* one : unit.survivors())
        text += fmt::format("  {}: {}: {}\n", place(unit, *one), one->mutant.kind, one->mutant.change);
    for (const Equivalent& entry : unit.stale)
        text += fmt::format("  entry out of date, no such mutant survives: {} ({})\n", entry.change, entry.line);
    return text;
}

std::string mutants_markdown(MutantFamily family, std::span<const UnitMutants> units)
{
    const bool slips = family == MutantFamily::slips;
    std::string page =
        slips ? "# Slips in the references\n\nMade by `umbral validate --slips --markdown docs/slips.md`. Each is one "
                "change of a unit's reference as students make them: another component, field or variable of the same "
                "type, an absolute tolerance, a value cut or normalised, the last round of a loop left out, two "
                "statements in the other order, an answer kept for arguments of the same sizes and numbers. "
              : "# Mutants of the references\n\nMade by `umbral validate --mutants --markdown docs/mutants.md`. Each "
                "mutant is one small change of a unit's reference. ";
    page += fmt::format(
        "It is killed if a check takes points for it.\nAn equivalent one is listed in the unit's `{}`, with the reason "
        "why no user could tell it from the reference; any other that survives shows what no check looks at.\n\n",
        entries_file(family));
    page += "| unit | mutants | killed | equivalent | survive |\n|---|---|---|---|---|\n";
    for (const UnitMutants& unit : units)
        page += unit.trouble.empty() ? fmt::format("| {} | {} | {} | {} | {} |\n", unit.unit, unit.mutants.size(),
                                                   unit.killed(), equivalent(unit), unit.survivors().size())
                                     : fmt::format("| {} | not tried: {} | | | |\n", unit.unit,
                                                   in_cell(unit.trouble.substr(0, unit.trouble.find('\n'))));
    for (const UnitMutants& unit : units) {
        if (unit.killed() == unit.mutants.size()) continue;
        page += fmt::format("\n## {}\n| place | kind | change | |\n|---|---|---|---|\n", unit.unit);
        for (const TriedMutant& one : unit.mutants)
            if (!one.trial.killed)
                page += fmt::format("| {} | {} | `{}` | {} |\n", place(unit, one), one.mutant.kind,
                                    in_cell(one.mutant.change),
                                    one.reason.empty() ? "survives" : "equivalent: " + in_cell(one.reason));
    }
    return page;
}

nlohmann::json mutants_json(std::span<const UnitMutants> units)
{
    nlohmann::json list = nlohmann::json::array();
    for (const UnitMutants& unit : units) {
        nlohmann::json mutants = nlohmann::json::array();
        for (const TriedMutant& one : unit.mutants)
            mutants.push_back({{"line", one.mutant.line},
                               {"kind", one.mutant.kind},
                               {"change", one.mutant.change},
                               {"killed", one.trial.killed},
                               {"by", one.trial.by},
                               {"equivalent", one.reason}});
        nlohmann::json stale = nlohmann::json::array();
        for (const Equivalent& entry : unit.stale)
            stale.push_back({{"line", entry.line}, {"change", entry.change}, {"reason", entry.reason}});
        list.push_back({{"unit", unit.unit},
                        {"file", unit.file},
                        {"mutants", mutants},
                        {"not_compiled", unit.not_compiled},
                        {"stale", stale},
                        {"trouble", unit.trouble},
                        {"holds", unit.holds()}});
    }
    return {{"format", "umbral-mutants"}, {"version", 1}, {"units", list}};
}

}
