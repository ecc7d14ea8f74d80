#include "json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace umbral::bench {
namespace {

using nlohmann::json;

/// The shortest time of a situation: what ratios are counted from.
double shortest(const Knob& knob, const std::string& situation)
{
    const std::vector<Result> some = results_in(knob, situation);
    return std::min_element(some.begin(), some.end(), [](const Result& a, const Result& b) { return a.time < b.time; })
        ->time;
}

json law_json(const Law& law)
{
    return {{"family", law.family},
            {"measure", law.measure.empty() ? json() : json(law.measure)},
            {"against", law.against},
            {"form", law.exponential ? "exponential" : "power"},
            {"order", law.order},
            {"slope", law.points < 3 ? json() : json(law.slope)},
            {"half_width", std::isfinite(law.half_width) ? json(law.half_width) : json()},
            {"points", law.points},
            {"verdict", law.verdict},
            {"reason", law.reason}};
}

json knob_json(const Knob& knob)
{
    json measures = json::array();
    for (const Measure& one : knob.measures)
        measures.push_back({{"id", one.id}, {"name", one.name}, {"unit", one.unit}});
    json situations = json::array();
    for (const Situation& one : knob.situations)
        situations.push_back({{"id", one.id}, {"label", one.label}, {"place", one.place}});
    json settings = json::array();
    for (const auto& [name, text] : knob.settings) settings.push_back({{"name", name}, {"text", text}});
    json results = json::array();
    for (const Result& one : knob.results)
        results.push_back({{"setting", one.setting},
                           {"situation", one.situation},
                           {"time", one.time},
                           {"ratio", one.time / shortest(knob, one.situation)},
                           {"errors", one.errors},
                           {"family", one.family},
                           {"amount", one.amount}});
    json curves = json::array();
    for (const Curve& one : knob.curves)
        curves.push_back({{"situation", one.situation},
                          {"measure", one.measure},
                          {"front", one.front},
                          {"knee", one.knee ? json(*one.knee) : json()},
                          {"sentence", one.sentence}});
    json laws = json::array();
    for (const Law& one : knob.laws) laws.push_back(law_json(one));
    return {{"id", knob.id},
            {"title", knob.title},
            {"text", knob.text},
            {"time_unit", knob.time_unit},
            {"axis", knob.axis},
            {"measures", measures},
            {"situations", situations},
            {"settings", settings},
            {"results", results},
            {"curves", curves},
            {"laws", laws}};
}

}

json to_json(const Accuracy& accuracy)
{
    json knobs = json::array();
    for (const Knob& knob : accuracy.knobs) knobs.push_back(knob_json(knob));
    return {{"format", "umbral-accuracy"},
            {"version", 1},
            {"quick", accuracy.quick},
            {"machine", {{"processor", accuracy.processor}, {"compiler", accuracy.compiler}, {"gl", accuracy.gl}}},
            {"knobs", knobs}};
}

}
