#include "render/report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

namespace umbral::render {
namespace {

using nlohmann::json;

bool is_absent(const Count& counter, const EffectSet& set)
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

json ray_effects_json(const Report& report)
{
    json effects = json::object();
    for (const rays::RayEffect& effect : report.ray_effects)
        effects[effect.name] = {{"called_for", effect.called_for}, {"drawn", report.follows_rays}, {"why", effect.why}};
    return effects;
}

json counters_json(const std::vector<Count>& counts)
{
    json list = json::object();
    for (const Count& count : counts) list[count.name] = count.value;
    return list;
}

}

std::string explanation(const Report& report)
{
    std::string text = "Effects that the scene calls for\n";
    for (std::size_t i = 0; i < effect_flags.size(); ++i)
        text += fmt::format("  {} {:<11} {}\n", report.derived.set.*effect_flags[i] ? "yes" : " no", effect_names[i],
                            report.derived.why[i]);
    text += report.follows_rays ? "Effects of rays\n"
                                : fmt::format("Effects of rays, which {} draws without\n", report.renderer);
    for (const rays::RayEffect& effect : report.ray_effects)
        text += fmt::format("  {} {:<11} {}\n", effect.called_for ? "yes" : " no", effect.name, effect.why);
    text += fmt::format("How {} leaves the others out: {}\n", report.renderer, report.how);
    if (report.counts.empty()) return text + "Counters: this renderer does not count its work\n";
    text += report.all_effects ? "Work done with all effects\n" : "Work done for these effects\n";
    for (const Count& count : report.counts)
        text += fmt::format(
            "  {:>12} {}{}\n", count.value, count.name,
            is_absent(count, report.derived.set) ? fmt::format("  ({} is not called for)", count.effect) : "");
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
                 {"effects", effects_json(report.derived)},
                 {"ray_effects", ray_effects_json(report)}};
    if (!report.out.empty()) root["out"] = report.out;
    if (!report.counts.empty()) root["counters"] = counters_json(report.counts);
    return root;
}

}
