#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What `umbral bench accuracy` measures: plain data, filled by the knobs and written as JSON, HTML and text.
namespace umbral::bench {

/// A way to be wrong: what is counted, and in what.
struct Measure {
    std::string id;    ///< "p95_ulp"
    std::string name;  ///< "95th percentile of the error of t"
    std::string unit;  ///< "ulp"
};

/// One situation in which all settings of a knob are measured.
struct Situation {
    std::string id;     ///< "1e4"
    std::string label;  ///< "from 10 000 radii"
    double place = 0;   ///< where it lies on the axis of situations; > 0
};

/// One setting in one situation.
struct Result {
    std::string setting;
    std::string situation;
    double time = 0;                       ///< in the knob's unit; > 0
    std::map<std::string, double> errors;  ///< by measure; >= 0
    std::string family = {};               ///< what settings of one kind share ("stratified"); may be empty
    double amount = 0;                     ///< how much of it was chosen ("16" samples); 0 if it is no number
};

/// Error against time in one situation. Settings are named in the order of their times.
struct Curve {
    std::string situation;
    std::string measure;
    std::vector<std::string> front;  ///< settings that no other beats in both time and error
    std::optional<std::string>
        knee;              ///< the setting of the front beyond which time buys least; none if the front has no bend
    std::string sentence;  ///< the same in plain words
};

/// How fast the error of a family falls, beside what theory says: error ~ amount^order, or, if `exponential`,
/// error ~ 10^(order amount).
struct Law {
    std::string family;   ///< of the results that it was fitted to
    std::string measure;  ///< the error that follows it; empty: the time
    std::string against;  ///< what the amounts count: "samples a pixel"
    bool exponential = false;
    double order = 0;        ///< theory's
    double slope = 0;        ///< by least squares through the logarithms
    double half_width = 0;   ///< of the slope's 95 % confidence interval, from the scatter round the line
    std::size_t points = 0;  ///< that were fitted: those with errors above 0
    std::string verdict;     ///< "as theory says", "differs" or "too few to tell"
    std::string reason;      ///< where the order comes from; where it differs, why
};

/// Something that trades accuracy for time, and what it was seen to cost.
struct Knob {
    std::string id;         ///< "ray-sphere"
    std::string title;      ///< "Where a ray meets a sphere"
    std::string text;       ///< what was measured, and how: one paragraph
    std::string time_unit;  ///< "ns per ray"
    std::string axis;       ///< what the situations' places count; empty for a single situation
    std::vector<Measure> measures;
    std::vector<Situation> situations;
    std::vector<std::pair<std::string, std::string>> settings;  ///< name, and what it does
    std::vector<Result> results;
    std::vector<Curve> curves;
    std::vector<Law> laws = {};  ///< none where no order is known
};

/// All knobs, and the machine they were measured on.
struct Accuracy {
    std::string processor;
    std::string compiler;
    std::string gl;  ///< what drew; empty if nothing was drawn
    bool quick = false;
    std::vector<Knob> knobs;
};

/// The results of one situation, in the order of `knob.results`.
[[nodiscard]] std::vector<Result> results_in(const Knob& knob, const std::string& situation);

/// The entry of a list with this id. Throws std::out_of_range that names it.
[[nodiscard]] const Measure& measure_of(const Knob& knob, const std::string& id);
[[nodiscard]] const Situation& situation_of(const Knob& knob, const std::string& id);

}
