#include "text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "knee.hpp"

namespace umbral::bench {
namespace {

std::string curve_text(const Knob& knob, const Curve& curve)
{
    const Measure& measure = measure_of(knob, curve.measure);
    const std::vector<Result> results = results_in(knob, curve.situation);
    std::string text =
        fmt::format("\n  {}, {}\n    {:<16}{:>14}{:>10}{:>20}\n", situation_of(knob, curve.situation).label,
                    measure.name, "setting", knob.time_unit, "ratio", measure.unit);
    double shortest = 0;
    for (const std::string& setting : curve.front) {
        const auto found =
            std::find_if(results.begin(), results.end(), [&](const Result& one) { return one.setting == setting; });
        if (shortest == 0) shortest = found->time;
        text += fmt::format("  {} {:<16}{:>14}{:>10}{:>20}\n", curve.knee == setting ? ">" : " ", setting,
                            number_text(found->time), number_text(found->time / shortest),
                            number_text(found->errors.at(curve.measure)));
    }
    return text + "    " + curve.sentence + "\n";
}

}

std::string text_of(const Accuracy& accuracy)
{
    std::string text;
    for (const Knob& knob : accuracy.knobs) {
        text += fmt::format("\n{} ({})\n", knob.title, knob.id);
        for (const Curve& curve : knob.curves) text += curve_text(knob, curve);
    }
    return text +
           "\n> is the knee: up to there a doubling of time buys more than on average, beyond it less. Settings that "
           "others beat are left out.\n";
}

}
