#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "render/budget/draw.hpp"

namespace umbral::render::budget {
namespace {

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

std::string text_of(const Setting& setting, const Setting& whole)
{
    return fmt::format("{} ray{} through each pixel, depth {} of {}, bounces {} of {}", setting.rays,
                       setting.rays == 1 ? "" : "s", setting.depth, whole.depth, setting.bounces, whole.bounces);
}

std::string text_of(const char* knob, const std::vector<Cut>& cuts)
{
    std::string text;
    for (const Cut& cut : cuts)
        if (cut.cost != 1 || cut.bias != 0)
            text += fmt::format("  {} {} of {}: {} missing, {:.2f} of the rays\n", knob, cut.value, cuts.front().value,
                                percent(cut.bias), cut.cost);
    return text;
}

}

std::string text_of(const Result& result)
{
    const Wish& wish = result.wish;
    const Predicted& predicted = result.choice.predicted;
    const std::string asked = wish.is_error ? percent(wish.value) : fmt::format("{:.3g} s", wish.value);
    std::string text = fmt::format(
        "Asked: {} {} (errors are root mean squares of displayed values, of full scale)\n"
        "Pilot: one pixel in {}, two scramblings each, {:.3g} s\n",
        wish.is_error ? "error" : "time", asked, result.pilot.every, result.pilot.seconds);
    for (const Noise& point : result.pilot.model.noise)
        text += fmt::format("  {:3} rays: noise {}\n", point.rays, percent(point.error));
    text += fmt::format("  the noise falls as rays^{:.2f}\n", noise_slope(result.pilot.model));
    text += text_of("depth", result.pilot.model.depths) + text_of("bounces", result.pilot.model.bounces);
    text += fmt::format("Chosen: {}\n", text_of(result.choice.setting, result.whole));
    const char* kind = wish.is_error ? "the cheapest whose predicted error is at most" : "the most accurate that fits";
    const char* nearest = wish.is_error ? "the most accurate that there is" : "the quickest that there is";
    text += result.choice.reached ? fmt::format("Why: {} {}, of {} settings\n", kind, asked, result.choice.compared)
                                  : fmt::format("Why: {}, since {} is out of reach\n", nearest, asked);
    if (result.planned_rays != result.choice.setting.rays)
        text += fmt::format("Half way: the pilot said {} rays; what half of them took says {}\n", result.planned_rays,
                            result.choice.setting.rays);
    text += fmt::format("Predicted: error {} (noise {}, missing {}); {:.3g} s in all, {:.3g} s of them the picture\n",
                        percent(predicted.error), percent(predicted.noise), percent(predicted.bias),
                        result.predicted_seconds, predicted.seconds);
    return text + fmt::format("Measured: error {}; {:.3g} s in all, {:.3g} s of them the picture\n",
                              percent(result.measured_error), result.measured_seconds, result.render_seconds);
}

nlohmann::json to_json(const Result& result)
{
    using nlohmann::json;
    const auto setting = [](const Setting& some) {
        return json{{"rays", some.rays}, {"depth", some.depth}, {"bounces", some.bounces}};
    };
    const auto cuts = [](const std::vector<Cut>& all) {
        json list = json::array();
        for (const Cut& cut : all) list.push_back({{"value", cut.value}, {"bias", cut.bias}, {"cost", cut.cost}});
        return list;
    };
    json noise = json::array();
    for (const Noise& point : result.pilot.model.noise) noise.push_back({{"rays", point.rays}, {"error", point.error}});
    const Predicted& predicted = result.choice.predicted;
    return {{"asked", {{result.wish.is_error ? "error" : "seconds", result.wish.value}}},
            {"pilot",
             {{"every", result.pilot.every},
              {"seconds", result.pilot.seconds},
              {"noise", noise},
              {"slope", noise_slope(result.pilot.model)},
              {"depths", cuts(result.pilot.model.depths)},
              {"bounces", cuts(result.pilot.model.bounces)}}},
            {"planned_rays", result.planned_rays},
            {"chosen", setting(result.choice.setting)},
            {"reached", result.choice.reached},
            {"predicted",
             {{"error", predicted.error},
              {"noise", predicted.noise},
              {"bias", predicted.bias},
              {"seconds", result.predicted_seconds},
              {"picture_seconds", predicted.seconds}}},
            {"measured",
             {{"error", result.measured_error},
              {"seconds", result.measured_seconds},
              {"picture_seconds", result.render_seconds}}}};
}

}
