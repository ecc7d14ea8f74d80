#pragma once

#include <bench/accuracy/knee.hpp>

namespace umbral::bench::test {

/// Measurements that nobody took: one knob with a bend in a single situation, one with two situations, zeros and
/// awkward texts.
inline Accuracy synthetic()
{
    Knob bend{"bend",
              "A <bend> & more",
              "What \"was\" measured",
              "ms",
              "",
              {{"e", "error", "px"}, {"f", "other error", "%"}},
              {{"only", "everywhere", 1}},
              {},
              {},
              {}};
    const std::vector<Offer> offers = {{1, 100}, {2, 1}, {4, 0.8}, {8, 0.6}, {3, 50}};
    for (std::size_t i = 0; i < offers.size(); ++i) {
        bend.settings.emplace_back("s" + std::to_string(i), "setting <" + std::to_string(i) + ">");
        bend.results.push_back(
            {"s" + std::to_string(i), "only", offers[i].time, {{"e", offers[i].error}, {"f", 2 * offers[i].error}}});
    }
    for (const char* measure : {"e", "f"}) bend.curves.push_back(curve_of(bend, "only", measure));

    Knob axis{"axis",
              "Over distance",
              "",
              "ns",
              "distance",
              {{"e", "error", "ulp"}},
              {{"near", "nearby", 1}, {"far", "far away", 1000}},
              {{"a", ""}, {"b", ""}},
              {},
              {}};
    axis.results = {{"a", "near", 1, {{"e", 0}}},
                    {"b", "near", 2, {{"e", 0}}},
                    {"a", "far", 1, {{"e", 1e4}}},
                    {"b", "far", 2, {{"e", 0.5}}}};
    for (const char* situation : {"near", "far"}) axis.curves.push_back(curve_of(axis, situation, "e"));
    return {"Some <CPU>", "g++ 12", "", false, {bend, axis}};
}

}
