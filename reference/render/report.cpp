#include "render/report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

namespace umbral::render {
namespace {

using nlohmann::json;

bool is_absent(const NamedCounter& counter, const EffectSet& set)
{
    for (std::size_t i = 0; i < effect_flags.size(); ++i)
        if (counter.effect != nullptr && counter.effect == std::string_view(effect_names[i]))
            return !(set.*effect_flags[i]);
    return false;
}

json effects_json(const Derived& derived)
{
    json effects = json::object();
    for (std::size_t i = 0; i < effect_flags.size(); ++i)
        effects[effect_names[i]] = {{"called_for", derived.set.*effect_flags[i]}, {"why", derived.why[i]}};
    return effects;
}

json counters_json(const Counters& counters)
{
    json list = json::object();
    for (const NamedCounter& counter : all_counters) list[counter.name] = counters.*counter.value;
    return list;
}

}

std::string explanation(const Report& report)
{
    std::string text = "Effects that the scene calls for\n";
    for (std::size_t i = 0; i < effect_flags.size(); ++i)
        text += fmt::format("  {} {:<11} {}\n", report.derived.set.*effect_flags[i] ? "yes" : " no", effect_names[i],
                            report.derived.why[i]);
    if (!report.counters) return text + "Counters: the software renderer counts its work; OpenGL does not tell.\n";
    text += report.all_effects ? "Work done by the kernel with all effects\n"
                               : "Work done by the kernel for these effects\n";
    for (const NamedCounter& counter : all_counters)
        text += fmt::format(
            "  {:>12} {}{}\n", (*report.counters).*counter.value, counter.name,
            is_absent(counter, report.derived.set) ? fmt::format("  ({} is not called for)", counter.effect) : "");
    return text;
}

json to_json(const Report& report)
{
    json root = {{"format", "umbral-render"},
                 {"version", 1},
                 {"scene", report.scene},
                 {"title", report.title},
                 {"renderer", report.renderer},
                 {"width", report.width},
                 {"height", report.height},
                 {"samples", report.samples},
                 {"kernel", report.all_effects ? "all" : "derived"},
                 {"effects", effects_json(report.derived)}};
    if (!report.out.empty()) root["out"] = report.out;
    if (report.counters) root["counters"] = counters_json(*report.counters);
    return root;
}

}
