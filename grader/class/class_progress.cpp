#include "class/class_progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbral::grader {
namespace {

/// Less work than this says nothing about the rest.
constexpr std::size_t least_units = 3;
constexpr double least_seconds = 2;

/// Rounded as people say it, never to nothing.
std::string duration(double seconds)
{
    if (seconds < 90) return fmt::format("{} s", std::max(5, static_cast<int>(std::ceil(seconds / 5)) * 5));
    const double minutes = std::ceil(seconds / 60);
    if (minutes < 90) return fmt::format("{:.0f} min", minutes);
    const int in_tens = static_cast<int>(std::min(std::ceil(minutes / 10), 1e6));
    return in_tens % 6 == 0 ? fmt::format("{} h", in_tens / 6)
                            : fmt::format("{} h {} min", in_tens / 6, in_tens % 6 * 10);
}

}

std::string progress_text(const ClassProgress& progress)
{
    std::string text = fmt::format("{}/{} {}", progress.submissions_done, progress.submissions,
                                   progress.submissions == 1 ? "submission" : "submissions");
    if (progress.units_graded < least_units || progress.seconds < least_seconds) return text;
    const double rate = static_cast<double>(progress.units_graded) / progress.seconds;
    text += rate >= 0.1 ? fmt::format(", {:.1f} units/s", rate) : fmt::format(", {:.1f} units/min", 60 * rate);
    if (progress.units_to_grade > progress.units_graded)
        text += fmt::format(", about {} left",
                            duration(static_cast<double>(progress.units_to_grade - progress.units_graded) / rate));
    return text;
}

}
