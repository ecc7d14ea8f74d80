#include <algorithm>
#include <cmath>

#include "judge/explain/thresholds.hpp"
#include "judge/judge.hpp"

namespace umbral::grader {

Millipoints points_for(const Check& check, double right, double control)
{
    const double low = std::max(check.zero, control);
    // A control as good as the full mark leaves no scale: only what beats both earns anything. NaN fails every
    // comparison.
    if (!(right > low)) return 0;
    if (right >= check.full) return check.points;
    return static_cast<Millipoints>(
        std::llround(static_cast<double>(check.points) * (right - low) / (check.full - low)));
}

Millipoints points_for(const Check& check, const Judgement& judgement, double control)
{
    const Millipoints points = points_for(check, judgement.right, control);
    if (judgement.clearly_wrong == 0 || check.full < 1 || check.hard) return points;
    const double most = (1 - thresholds::clear_cost) * static_cast<double>(check.points);
    return std::min(points, static_cast<Millipoints>(std::llround(most)));
}

}
