#include "judge/statistics/error_budget.hpp"

#include <algorithm>
#include <cmath>

#include "judge/explain/thresholds.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

double sidak(double alpha, double tests) { return alpha >= 1 ? 1 : -std::expm1(std::log1p(-alpha) / tests); }

double sidak_probability(double smallest, double tests)
{
    return smallest >= 1 ? 1 : -std::expm1(tests * std::log1p(-smallest));
}

double check_alpha() { return sidak(thresholds::submission_alpha, most_noise_checks); }

double two_stage_probability(double first, double second, double borderline)
{
    if (first >= borderline) return first;
    const double product = first * second;
    return product > 0 ? product * (1 + std::log(borderline / product)) : 0;
}

FirstRun after_first_run(double first)
{
    if (first >= thresholds::noise_borderline) return FirstRun::right;
    return two_stage_probability(first, 1, thresholds::noise_borderline) < check_alpha() ? FirstRun::wrong
                                                                                         : FirstRun::borderline;
}

}
