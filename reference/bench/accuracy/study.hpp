#pragma once

#include <functional>

#include "knob.hpp"
#include "law.hpp"

namespace umbral::bench {

/// One setting of a study.
struct Trial {
    std::string setting;  ///< its name: "stratified 16"
    std::string family;   ///< settings of one kind: "stratified"; may be empty
    double amount = 0;    ///< how much of it: 16; 0 if it is no number
    std::map<std::string, double> errors;
    double operations = 1;       ///< what one call of `work` does, in the units of the knob's time
    std::function<void()> work;  ///< what is timed; its results go through `keep`
    std::string situation = "all";
    std::string meaning = {};  ///< what it does, where the name does not say it
};

/// A knob whose settings are measured in one way: errors are computed by the knob, times here.
struct Study {
    Knob knob;  ///< without settings, results, curves and laws; a single situation "all" is added if there is none
    double seconds_unit = 1e9;  ///< how many of the knob's unit of time a second has: 1e9 for ns
    std::vector<Trial> trials;
    std::vector<Expectation> laws;
};

/// A study of one situation, or, with an axis, of those that the caller adds; nothing is measured yet.
[[nodiscard]] Study study_of(std::string id, std::string title, std::string text, std::string time_unit,
                             std::vector<Measure> measures, double seconds_unit = 1e9, std::string axis = "");

/// Times the trials in turns and completes the knob.
[[nodiscard]] Knob finish(Study study, const Means& means);

/// Tells the compiler that somebody looks at this value, so that computing it cannot be left out.
template <class Value>
void keep(const Value& value)
{
    asm volatile("" : : "r"(&value) : "memory");
}

/// The root of the mean square of errors.
[[nodiscard]] double root_mean_square(std::span<const double> errors);

}
