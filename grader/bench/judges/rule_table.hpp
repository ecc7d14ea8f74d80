#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/judges/picture_rules.hpp"

namespace umbral::grader {

/// What is kept of a PicturePair.
struct MeasuredPair {
    std::string scene;
    std::string change;
    bool harmful = false;
    bool noise = false;
    bool made_up = false;
    bool held_out = false;
    bool invisible =
        false;  ///< harmful, but the picture looks the same: this scene cannot show that fault, whatever the rule
    OurMeasure ours{};
    PictureMeasures measures{};
};

/// Wrong pictures that count: the scene shows the fault.
[[nodiscard]] inline bool is_bug(const MeasuredPair& pair) { return pair.harmful && !pair.invisible; }

/// How a rule with one threshold does on the half that was held out.
struct RuleResult {
    PictureRule rule{};
    std::string origin;  ///< of the threshold: "in use", "0.99", "best on the other half"
    double threshold = 0;
    std::size_t caught = 0;
    std::size_t bugs = 0;
    std::size_t alarms = 0;
    std::size_t harmless = 0;
};

/// The smallest threshold under which the rule raises no alarm on the half for calibration: it catches the most there
/// that can be caught.
[[nodiscard]] double fitted_threshold(std::span<const MeasuredPair> pairs, PictureRule rule);

/// Every rule with its published threshold, and with its best one (ours with the one in use only), on the half that was
/// held out.
[[nodiscard]] std::vector<RuleResult> compare_rules(std::span<const MeasuredPair> pairs);

/// How far harmless pictures stay from the threshold (1), and what follows for those never seen.
struct Margins {
    std::size_t count = 0;
    double median = 0;
    double percentile90 = 0;
    double percentile99 = 0;
    double largest = 0;
    double alarm_rate = 0;  ///< chance that a harmless picture exceeds 1, by the tail that the largest ratios follow
};

/// `ratios` of harmless pictures to the threshold. If none exceeds it, the rate is estimated from the largest tenth (at
/// least ten) by a generalised Pareto tail: rates fall as a power, or exponentially, or end at a bound. It speaks of
/// pictures like these ones only. Based on: A. Dekkers, J. Einmahl, L. de Haan. A Moment Estimator for the Index of an
/// Extreme-Value Distribution. 1989.
[[nodiscard]] Margins margins_of(std::vector<double> ratios);

/// The chance that a submission with `pictures` right pictures is blamed for one of them.
[[nodiscard]] double alarms_of_submission(double rate, double pictures);

}
