#include "overview.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "axis.hpp"
#include "knee.hpp"
#include "text/escape.hpp"

namespace umbral::bench {
namespace {

constexpr double width = 200;
constexpr double height = 104;

/// The results of the shown situation by families, cheapest first; settings without one are a line of their own.
std::vector<std::pair<std::string, std::vector<Result>>> families_of(const Knob& knob, const Curve& curve)
{
    std::vector<std::pair<std::string, std::vector<Result>>> families;
    for (const Result& result : results_in(knob, curve.situation)) {
        const std::string name = knob.situations.size() > 1 ? "" : result.family;
        const auto found =
            std::find_if(families.begin(), families.end(), [&](const auto& family) { return family.first == name; });
        if (found == families.end())
            families.push_back({name, {result}});
        else
            found->second.push_back(result);
    }
    for (auto& [family, results] : families)
        std::stable_sort(results.begin(), results.end(),
                         [](const Result& a, const Result& b) { return a.time < b.time; });
    return families;
}

bool is_on_front(const Curve& curve, const Result& result)
{
    return std::find(curve.front.begin(), curve.front.end(), result.setting) != curve.front.end();
}

std::string small_plot(const Knob& knob)
{
    const Curve& curve = main_curve_of(knob);
    std::vector<double> times;
    std::vector<double> errors;
    bool has_zero = false;
    for (const Result& result : results_in(knob, curve.situation)) {
        times.push_back(result.time);
        errors.push_back(result.errors.at(curve.measure));
        has_zero = has_zero || errors.back() == 0;
    }
    const LogAxis x(times, 0, width, 12, 12);
    const LogAxis y(errors, height - (has_zero ? 16 : 0), 0, 8, 10);
    const auto place_y = [&](double error) { return error > 0 ? y.at(error) : height - 6; };
    std::string text = fmt::format("<svg viewBox=\"0 0 {} {}\" aria-hidden=\"true\">", width, height);
    if (has_zero) text += fmt::format("<path class=\"zero\" d=\"M0 {}H{}\"/>", height - 14, width);
    int number = 0;
    std::string marks;
    std::string ring;
    for (const auto& [family, results] : families_of(knob, curve)) {
        std::string line;
        marks += fmt::format("<g class=\"s{}\">", number % 6);
        for (const Result& result : results) {
            const double error = result.errors.at(curve.measure);
            if (!std::isfinite(error)) continue;
            const bool front = is_on_front(curve, result);
            // A family is joined; settings that are none are joined along the front.
            if (!family.empty() || front)
                line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? 'M' : 'L', x.at(result.time), place_y(error));
            marks += fmt::format("<circle class=\"mark{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>",
                                 front ? "" : " quiet", x.at(result.time), place_y(error));
            if (curve.knee == result.setting)
                ring = fmt::format("<circle class=\"ring\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\"/>", x.at(result.time),
                                   place_y(error));
        }
        marks += "</g>";
        if (!line.empty()) text += fmt::format("<path class=\"line s{}\" d=\"{}\"/>", number % 6, line);
        ++number;
    }
    return text + marks + ring + "</svg>";
}

std::string card_of(const Knob& knob)
{
    const Curve& curve = main_curve_of(knob);
    std::string text = fmt::format("<a class=\"card\" href=\"#{}\"><b>{}</b>{}<span class=\"knee-line{}\">{}</span>",
                                   escape_html(knob.id), escape_html(knob.title), small_plot(knob),
                                   curve.knee ? "" : " none", escape_html(curve.knee.value_or("no bend")));
    std::string slopes;
    // The law that is farthest from theory is the one that somebody should see.
    const auto shown =
        std::find_if(knob.laws.begin(), knob.laws.end(), [](const Law& law) { return law.verdict == "differs"; });
    if (!knob.laws.empty()) {
        const Law& law = shown != knob.laws.end() ? *shown : knob.laws.front();
        slopes =
            fmt::format("{}{}", law.family.empty() ? "" : escape_html(law.family) + " ", escape_html(slope_text(law)));
    }
    return text +
           fmt::format("<span class=\"slope{}\">{}</span></a>\n", shown != knob.laws.end() ? " differs" : "", slopes);
}

}

const Curve& main_curve_of(const Knob& knob)
{
    return knob.curves.at(knob.situations.size() > 1 ? knob.curves.size() / 2 : 0);
}

std::string slope_text(const Law& law)
{
    if (law.points < 3) return "too few points";
    const double slope = std::abs(law.slope) < 0.005 ? 0 : law.slope;  // no "-0.00"
    const char* sign = law.verdict == "as theory says" ? "✓" : law.verdict == "differs" ? "≠" : "?";
    return fmt::format("{:.2f} ± {:.2f} {} {:.3g}", slope, law.half_width, sign, law.order);
}

std::string overview_of(const Accuracy& accuracy)
{
    std::string text = "<nav class=\"overview\" aria-label=\"All knobs\">\n";
    for (const Knob& knob : accuracy.knobs)
        if (!knob.curves.empty()) text += card_of(knob);
    return text + "</nav>\n";
}

}
