#include "law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace umbral::bench {
namespace {

/// The 97.5 % quantile of Student's t.
double student(std::size_t freedom)
{
    constexpr std::array quantiles = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                                      2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086};
    if (freedom == 0) return std::numeric_limits<double>::infinity();
    return freedom <= quantiles.size() ? quantiles[freedom - 1] : 2.08;
}

}

Line fit_line(std::span<const double> x, std::span<const double> y)
{
    if (x.size() != y.size() || x.size() < 2)
        throw std::invalid_argument("fit_line: expected as many x as y, two at least; got " + std::to_string(x.size()) +
                                    " and " + std::to_string(y.size()));
    const auto count = static_cast<double>(x.size());
    double mean_x = 0;
    double mean_y = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / count;
        mean_y += y[i] / count;
    }
    double xx = 0;
    double xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    if (!(xx > 0)) throw std::invalid_argument("fit_line: expected two different x, got one");
    Line line{xy / xx, mean_y - xy / xx * mean_x, std::numeric_limits<double>::infinity()};
    if (x.size() == 2) return line;
    double squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double off = y[i] - line.intercept - line.slope * x[i];
        squares += off * off;
    }
    line.half_width = student(x.size() - 2) * std::sqrt(squares / (count - 2) / xx);
    return line;
}

Law law_of(const Knob& knob, const Expectation& expected)
{
    std::vector<double> x;
    std::vector<double> y;
    for (const Result& result : knob.results) {
        const double error = expected.measure.empty() ? result.time : result.errors.at(expected.measure);
        if (result.family != expected.family || !(result.amount > 0) || !(error > 0) || !std::isfinite(error)) continue;
        x.push_back(expected.exponential ? result.amount : std::log10(result.amount));
        y.push_back(std::log10(error));
    }
    Law law{expected.family,
            expected.measure,
            expected.against,
            expected.exponential,
            expected.order,
            0,
            std::numeric_limits<double>::infinity(),
            x.size(),
            "too few to tell",
            expected.reason};
    if (x.size() < 3) return law;
    const Line line = fit_line(x, y);
    law.slope = line.slope;
    law.half_width = line.half_width;
    const double scale = expected.exponential ? std::abs(expected.order) : std::max(1.0, std::abs(expected.order));
    if (law.half_width > widest_interval * scale) return law;
    const bool agrees = std::abs(law.slope - law.order) <= std::max(law.half_width, order_tolerance * scale);
    law.verdict = agrees ? "as theory says" : "differs";
    if (!agrees) law.reason += " " + expected.otherwise;
    return law;
}

std::string sentence_of(const Knob& knob, const Law& law)
{
    const std::string name = law.family.empty() ? "" : law.family + ": ";
    const std::string measure = law.measure.empty() ? "time" : measure_of(knob, law.measure).name;
    if (law.points < 3)
        return fmt::format("{}{} against {}: {} points, {}. {}", name, measure, law.against, law.points, law.verdict,
                           law.reason);
    const char* form = law.exponential ? "{}{} falls as 10^(k × {}), k = {:.3g} ± {:.2g}; theory {:.3g}: {}. {}"
                                       : "{}{} goes as {} to the power {:.2f} ± {:.2f}; theory {:.3g}: {}. {}";
    return fmt::format(fmt::runtime(form), name, measure, law.against, law.slope, law.half_width, law.order,
                       law.verdict, law.reason);
}

}
