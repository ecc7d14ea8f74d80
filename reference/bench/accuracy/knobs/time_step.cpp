#include <fmt/format.h>

#include <cmath>
#include <glm/glm.hpp>

#include "../study.hpp"

namespace umbral::bench {
namespace {

/// Place and velocity in a plane, about a centre that attracts by 1/r².
using State = glm::dvec4;
constexpr double period = 6.283185307179586;   // of an ellipse with the semi-axis 1
const State start(0.5, 0, 0, std::sqrt(3.0));  // eccentricity ½, nearest to the centre

State rate(const State& s)
{
    const double squared = s.x * s.x + s.y * s.y;
    const double pull = 1 / (squared * std::sqrt(squared));
    return {s.z, s.w, -pull * s.x, -pull * s.y};
}

State euler(const State& s, double h) { return s + h * rate(s); }

State leapfrog(const State& s, double h)
{
    const State first = rate(s);
    const glm::dvec2 half = glm::dvec2(s.z, s.w) + h / 2 * glm::dvec2(first.z, first.w);
    const glm::dvec2 place = glm::dvec2(s.x, s.y) + h * half;
    const State second = rate(State(place, half));
    return State(place, half + h / 2 * glm::dvec2(second.z, second.w));
}

State runge_kutta(const State& s, double h)
{
    const State a = rate(s);
    const State b = rate(s + h / 2 * a);
    const State c = rate(s + h / 2 * b);
    const State d = rate(s + h * c);
    return s + h / 6 * (a + 2.0 * b + 2.0 * c + d);
}

State fixed_steps(State (*step)(const State&, double), int count)
{
    State s = start;
    for (int i = 0; i < count; ++i) s = step(s, period / count);
    return s;
}

/// Steps that the difference of two orders chooses. P. Bogacki, L. Shampine. A 3(2) pair of Runge-Kutta formulas. 1989.
State adaptive(double tolerance, int& steps)
{
    State s = start;
    State first = rate(s);
    double h = 0.01;
    steps = 0;
    for (double t = 0; t < period;) {
        h = std::min(h, period - t);
        const State second = rate(s + h / 2 * first);
        const State third = rate(s + 0.75 * h * second);
        const State next = s + h / 9 * (2.0 * first + 3.0 * second + 4.0 * third);
        const State last = rate(next);
        const State off = h * (-5.0 / 72 * first + 1.0 / 12 * second + 1.0 / 9 * third - 1.0 / 8 * last);
        const double error = length(off);
        ++steps;
        if (error <= tolerance) {
            t = h == period - t ? period : t + h;
            s = next;
            first = last;
        }
        h *= std::clamp(0.9 * std::cbrt(tolerance / std::max(error, 1e-300)), 0.2, 4.0);
    }
    return s;
}

double off_start(const State& s) { return std::hypot(s.x - start.x, s.y - start.y); }

}

Knob measure_time_step(Means& means)
{
    Study study = study_of("time-step", "Time steps, fixed, adaptive",
                           "Once round an ellipse of eccentricity ½: how far from its beginning the orbit ends, which "
                           "exactly is nothing. Adaptive steps are Bogacki's and Shampine's, of third order.",
                           "µs per orbit", {{"off", "distance to the true place", "semi-axes"}}, 1e6);
    const std::vector<std::pair<std::string, State (*)(const State&, double)>> methods = {
        {"Euler", euler}, {"leapfrog", leapfrog}, {"Runge-Kutta", runge_kutta}};
    for (const auto& [family, method] : methods)
        for (const int count : {256, 512, 1024, 2048, 4096, 8192})
            if (family != "Euler" || count > 512)
                study.trials.push_back({fmt::format("{} {}", family, count),
                                        family,
                                        static_cast<double>(count),
                                        {{"off", off_start(fixed_steps(method, count))}},
                                        1,
                                        [method = method, count] { keep(fixed_steps(method, count)); }});
    for (const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
        int steps = 0;
        const double off = off_start(adaptive(tolerance, steps));
        study.trials.push_back(
            {fmt::format("adaptive {}", steps), "adaptive", static_cast<double>(steps), {{"off", off}}, 1, [tolerance] {
                 int count = 0;
                 keep(adaptive(tolerance, count));
             }});
    }
    study.laws = {{"Euler", "off", "steps", -1, "Each step errs by h², and there are 1/h of them.",
                   "With steps as coarse as these the orbit leaves the ellipse."},
                  {"leapfrog", "off", "steps", -2, "Symmetric in time: h³ a step.", ""},
                  {"Runge-Kutta", "off", "steps", -4, "Four rates cancel all but h⁵ a step.",
                   "Near the roundings of double nothing falls."},
                  {"adaptive", "off", "steps", -3, "The pair's better formula errs by h⁴ a step.",
                   "Steps are chosen by a bound on the error, not by their number."}};
    return finish(std::move(study), means);
}

}
