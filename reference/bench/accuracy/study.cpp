#include "study.hpp"

#include <algorithm>
#include <cmath>

#include "knee.hpp"
#include "timing.hpp"

namespace umbral::bench {

Study study_of(std::string id, std::string title, std::string text, std::string time_unit,
               std::vector<Measure> measures, double seconds_unit, std::string axis)
{
    Study study{};
    study.knob.id = std::move(id);
    study.knob.title = std::move(title);
    study.knob.text = std::move(text);
    study.knob.time_unit = std::move(time_unit);
    study.knob.axis = std::move(axis);
    study.knob.measures = std::move(measures);
    study.seconds_unit = seconds_unit;
    return study;
}

Knob finish(Study study, const Means& means)
{
    Knob knob = std::move(study.knob);
    if (knob.situations.empty()) knob.situations.push_back({"all", knob.title, 1});
    std::vector<std::function<void()>> work;
    for (const Trial& trial : study.trials) {
        const auto same = [&](const auto& setting) { return setting.first == trial.setting; };
        if (std::none_of(knob.settings.begin(), knob.settings.end(), same))
            knob.settings.emplace_back(trial.setting, trial.meaning);
        knob.results.push_back({trial.setting, trial.situation, 0, trial.errors, trial.family, trial.amount});
        work.push_back(trial.work);
    }
    const std::vector<double> seconds =
        fastest_of_interleaved(work, means.quick ? Patience{6, 3, 0.8, 0.003} : Patience{25, 4, 6, 0.01});
    for (std::size_t i = 0; i < seconds.size(); ++i)
        knob.results[i].time = std::max(seconds[i], 1e-9) * study.seconds_unit / study.trials[i].operations;
    if (knob.situations.size() > 1)
        for (const Situation& situation : knob.situations)
            knob.curves.push_back(curve_of(knob, situation.id, knob.measures.front().id));
    else
        for (const Measure& measure : knob.measures)
            knob.curves.push_back(curve_of(knob, knob.situations.front().id, measure.id));
    for (const Expectation& expected : study.laws) knob.laws.push_back(law_of(knob, expected));
    return knob;
}

double root_mean_square(std::span<const double> errors)
{
    double sum = 0;
    for (const double error : errors) sum += error * error;
    return errors.empty() ? 0 : std::sqrt(sum / static_cast<double>(errors.size()));
}

}
