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

double percent(std::size_t part, std::size_t of)
{
    return of == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(of);
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

json comparison_json(const Comparison& c)
{
    return {{"pixels", c.pixels},
            {"covered", {{"software", c.covered_first}, {"gl", c.covered_second}}},
            {"coverage_differs", c.coverage_differs},
            {"ids_differ", c.ids_differ},
            {"interior_pixels", c.interior},
            {"depth_max", c.depth_max},
            {"depth_mean", c.depth_mean},
            {"color_max", c.color_max},
            {"color_mean", c.color_mean},
            {"color_beyond", c.color_beyond},
            {"color_rmse", c.color_rmse}};
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

std::string comparison_table(const Report& report)
{
    const Comparison& c = *report.comparison;
    std::string text = fmt::format("software against gl: {} at {} x {}\n",
                                   report.title.empty() ? report.scene : report.title, report.width, report.height);
    const auto row = [&](const std::string& what, const std::string& value, const std::string& allowed) {
        text += fmt::format("  {:<38} {:>16}   {}\n", what, value, allowed);
    };
    row("", "measured", "allowed");
    row("pixels", fmt::format("{}", c.pixels), "");
    row("covered: software", fmt::format("{}", c.covered_first), "");
    row("covered: gl", fmt::format("{}", c.covered_second), "");
    row("pixels differing in coverage", fmt::format("{}", c.coverage_differs), "");
    row("pixels differing in id", fmt::format("{}", c.ids_differ),
        fmt::format("{:g} % of the pixels", 100 * report.agreement.edge_fraction));
    row("interior pixels", fmt::format("{} ({:.1f} %)", c.interior, percent(c.interior, c.pixels)), "");
    row("depth: largest, interior", fmt::format("{:.3g}", c.depth_max),
        fmt::format("{:.3g}", report.agreement.depth_most));
    row("depth: mean, interior", fmt::format("{:.3g}", c.depth_mean),
        fmt::format("{:.3g}", report.agreement.depth_mean));
    row("colour: largest, interior, in 1/255", fmt::format("{:.3g}", c.color_max), "");
    row("colour: mean, interior, in 1/255", fmt::format("{:.3g}", c.color_mean), "");
    row("colour: interior pixels beyond 1/255", fmt::format("{}", c.color_beyond),
        fmt::format("{:g} % of them", 100 * report.agreement.color_fraction));
    row("colour: RMSE, all pixels, in 1/255", fmt::format("{:.3g}", c.color_rmse), "");
    return text + (agrees(c, report.agreement) ? "  they agree\n" : "  THEY DIFFER by more than is allowed\n");
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
    if (report.comparison) {
        root["comparison"] = comparison_json(*report.comparison);
        root["agree"] = agrees(*report.comparison, report.agreement);
    }
    return root;
}

}
