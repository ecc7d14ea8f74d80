#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/exercise.hpp"
#include "model/scorecard.hpp"

#include <umbral/record/tensor.hpp>

namespace umbral::grader {

/// What one comparison gives, before controls and points.
struct Judgement {
    double right = 0;  ///< the fraction that is right, 0..1 (an image: 1 within the thresholds, falling to 0)
    std::optional<double>
        error;            ///< the worst error in the unit of the tolerance; empty if not finite or not comparable
    std::string message;  ///< one line: what is wrong, where; empty if all is right
    std::map<std::string, double> metrics;
    std::optional<Difference> first_difference;
    std::string headline{};  ///< the message up to its values, for where these are shown anyway; empty: it has none
    std::string sketch{};    ///< a picture in ASCII of the first bad place; empty where there is nothing to draw
    std::optional<double> chance{};  ///< judged by statistics: the chance that correct work deviates so much
    /// Rows or events so wrong that no rounding explains them: absent, too many, not finite, or further off than
    /// thresholds::clear_ratio times each bound. Other judges count none.
    std::size_t clearly_wrong = 0;
    bool borderline = false;  ///< another run with a fresh seed must decide (JudgeRecord::judge_both)
};

/// Compares what the student recorded with what was expected, by the check's rule. Trusts `expected` and `margin` only:
/// a non-finite value, another shape, type or presence is wrong, never an exception. `margin` (may be null) is the
/// expected recording's column "<value>.margin": rows where it is under the check's band_ulps do not count. `names`
/// (may be null) is the expected recording's text "<value>.names": for events lines such as "3 zoom" that name the
/// codes, and their numbers ("3 zoom: centre/2, factor": columns.hpp), for numbers what these are called, for fragments
/// the word for a primitive
/// ("triangle" without it), for costs what there are `size` of ("items" without it).
/// Throws std::invalid_argument if the check cannot be judged at all (no row counts, unknown rule): a grader fault.
[[nodiscard]] Judgement judge(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* margin,
                              const Tensor* names = nullptr);

/// Recordings that know nothing of the problem, of the shape of `expected`, by name: zeros, ones (the forger's "true"),
/// and what else the check's judge says.
[[nodiscard]] std::vector<std::pair<std::string, Tensor>> controls(const Check& check, const Tensor& expected,
                                                                   std::uint64_t seed);

/// The best that a control gets for this check (its `right`), and which one it is.
struct BestControl {
    std::string name;
    double right = 0;
};
[[nodiscard]] BestControl best_control(const Check& check, const Tensor& expected, const Tensor* margin,
                                       std::uint64_t seed);

/// Points for a fraction right: linear from max(check.zero, control) to check.full.
[[nodiscard]] Millipoints points_for(const Check& check, double right, double control);

/// Points for what was judged: those for its fraction right. Rows and events that are clearly wrong, however few, cost
/// at least the share thresholds::clear_cost of a check that expects all rows right, unless it is a hard one: a case
/// that was forgotten is a mistake, also where random inputs seldom meet it.
[[nodiscard]] Millipoints points_for(const Check& check, const Judgement& judgement, double control);

}
