#include "figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "knee.hpp"

namespace umbral::bench {
namespace {

std::string tip_of(const Knob& knob, const Result& result)
{
    std::string tip = result.setting;
    if (knob.situations.size() > 1) tip += ", " + situation_of(knob, result.situation).label;
    tip += fmt::format("\n{} {}", number_text(result.time), knob.time_unit);
    for (const Measure& measure : knob.measures)
        tip += fmt::format("\n{}: {} {}", measure.name, number_text(result.errors.at(measure.id)), measure.unit);
    return tip;
}

bool is_on_front(const Curve& curve, const std::string& setting)
{
    return std::find(curve.front.begin(), curve.front.end(), setting) != curve.front.end();
}

/// Error against time, cheapest first; what the front beats is quiet.
Series against_time(const Knob& knob, const Curve& curve)
{
    Series series{"", {}, true};
    for (const Result& result : results_in(knob, curve.situation)) {
        const bool quiet = !is_on_front(curve, result.setting);
        series.marks.push_back({result.time, result.errors.at(curve.measure), quiet ? "" : result.setting,
                                tip_of(knob, result), curve.knee == result.setting, quiet});
    }
    std::stable_sort(series.marks.begin(), series.marks.end(), [](const Mark& a, const Mark& b) { return a.x < b.x; });
    return series;
}

/// One line a family, where there are families; what the front beats keeps its place in the line.
std::vector<Series> by_family(Series all, const Knob& knob, const Curve& curve)
{
    std::vector<Series> families;
    for (const Mark& mark : all.marks) {
        const std::vector<Result> results = results_in(knob, curve.situation);
        const auto result = std::find_if(results.begin(), results.end(),
                                         [&](const Result& one) { return mark.tip == tip_of(knob, one); });
        if (result->family.empty() || result->amount == 0) return {std::move(all)};
        const auto family = std::find_if(families.begin(), families.end(),
                                         [&](const Series& one) { return one.name == result->family; });
        Series& series = family != families.end() ? *family : families.emplace_back(Series{result->family, {}, true});
        series.marks.push_back(mark);
        series.marks.back().quiet = false;
        if (!mark.knee) series.marks.back().label.clear();
    }
    return families;
}

std::string with_unit(const Measure& measure) { return measure.name + ", " + measure.unit; }

Plot empty_plot(const Knob& knob, const std::string& id, const Measure& measure, const std::string& x_label)
{
    return {knob.id + "-" + id,
            fmt::format("{}: {} against {}", knob.title, with_unit(measure), x_label),
            x_label,
            with_unit(measure),
            {}};
}

/// Two of them stand side by side.
Plot small(Plot plot)
{
    plot.width = 500;
    plot.height = 330;
    return plot;
}

/// A sentence a curve; if all have the same knee, that is said once.
std::vector<std::string> captions_of(const Knob& knob)
{
    std::vector<std::string> captions;
    for (const Curve& curve : knob.curves)
        captions.push_back(situation_of(knob, curve.situation).label + " — " + curve.sentence);
    const Curve& last = knob.curves.back();
    const bool all_alike = std::all_of(knob.curves.begin(), knob.curves.end(),
                                       [&](const Curve& curve) { return curve.knee == last.knee; });
    if (!all_alike || !last.knee) return captions;
    return {"The knee is the same in every situation: " + *last.knee + ".", captions.back()};
}

/// One column a setting, with its errors in all situations: how tall it is says how much they matter. Ringed is the
/// knee of each situation.
Figure all_situations(const Knob& knob)
{
    const std::string& measure = knob.curves.front().measure;
    Figure figure{empty_plot(knob, "time", measure_of(knob, measure), knob.time_unit), {}};
    for (const auto& [setting, text] : knob.settings) {
        Series series{"", {}, true};
        for (const Curve& curve : knob.curves)
            for (const Result& result : results_in(knob, curve.situation))
                if (result.setting == setting)
                    series.marks.push_back({result.time, result.errors.at(measure),
                                            situation_of(knob, result.situation).label, tip_of(knob, result),
                                            curve.knee == setting, false});
        if (series.marks.empty()) continue;
        // The name stands beside the topmost mark; situations are named where they make a difference.
        const auto [bottom, top] = std::minmax_element(series.marks.begin(), series.marks.end(),
                                                       [](const Mark& a, const Mark& b) { return a.y < b.y; });
        const bool tall = top->y > 10 * bottom->y;
        for (Mark& mark : series.marks)
            if (!tall && &mark != &*top) mark.label.clear();
        top->label = tall ? setting + ", " + top->label : setting;
        figure.plot.series.push_back(std::move(series));
    }
    figure.captions = captions_of(knob);
    return figure;
}

Figure over_axis(const Knob& knob, const Measure& measure)
{
    Figure figure{small(empty_plot(knob, "over-" + measure.id, measure, knob.axis)), {}};
    for (const auto& [setting, text] : knob.settings) {
        Series series{setting, {}, true};
        for (const Result& result : knob.results)
            if (result.setting == setting)
                series.marks.push_back({situation_of(knob, result.situation).place, result.errors.at(measure.id), "",
                                        tip_of(knob, result), false, false});
        figure.plot.series.push_back(series);
    }
    return figure;
}

}

std::vector<Figure> figures_of(const Knob& knob)
{
    std::vector<Figure> figures;
    if (knob.curves.empty()) return figures;
    if (knob.situations.size() > 1) {
        figures.push_back(all_situations(knob));
        for (std::size_t i = 1; i < knob.measures.size(); ++i) figures.push_back(over_axis(knob, knob.measures[i]));
        return figures;
    }
    for (const Curve& curve : knob.curves) {
        Figure figure{empty_plot(knob, curve.measure, measure_of(knob, curve.measure), knob.time_unit),
                      {curve.sentence}};
        if (!figures.empty()) figure.plot = small(std::move(figure.plot));
        figure.plot.series = by_family(against_time(knob, curve), knob, curve);
        figures.push_back(std::move(figure));
    }
    return figures;
}

}
