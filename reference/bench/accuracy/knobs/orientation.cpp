#include <fmt/format.h>

#include <array>
#include <cmath>
#include <umbral/core/random.hpp>

#include "../study.hpp"
#include "../textbook.hpp"

namespace umbral::bench {
namespace {

using Corners = std::array<glm::dvec2, 3>;

/// On which side of the line through a and b is c? By the determinant, in one width of numbers.
template <class Number>
int side_of(const Corners& p)
{
    const Number ax = static_cast<Number>(p[0].x) - static_cast<Number>(p[2].x);
    const Number ay = static_cast<Number>(p[0].y) - static_cast<Number>(p[2].y);
    const Number bx = static_cast<Number>(p[1].x) - static_cast<Number>(p[2].x);
    const Number by = static_cast<Number>(p[1].y) - static_cast<Number>(p[2].y);
    const Number determinant = ax * by - ay * bx;
    return (determinant > 0) - (determinant < 0);
}

/// Shewchuk's filter: double, and 113 bits only where the bound of its error does not settle the sign.
int filtered(const Corners& p)
{
    const double left = (p[0].x - p[2].x) * (p[1].y - p[2].y);
    const double right = (p[0].y - p[2].y) * (p[1].x - p[2].x);
    const double determinant = left - right;
    const double bound = 3.3306690738754716e-16 * (std::abs(left) + std::abs(right));
    if (determinant > bound || -determinant > bound) return (determinant > 0) - (determinant < 0);
    return side_of<Wide>(p);
}

/// Three points within [0.5, 1) near a common line; of ten triples one is as near as numbers can be.
Corners random_corners(Random& random)
{
    const auto coordinate = [&random] { return 0.5 + 0.5 * random.uniform_double(); };
    const double x = coordinate();
    const double y = coordinate();
    const double along = random.uniform_double();
    const glm::dvec2 a(x, coordinate());
    const glm::dvec2 b(y, coordinate());
    const double away = random.below(10) == 0 ? 1e-16 : 1e-3 * random.uniform_double();
    const glm::dvec2 c = mix(a, b, along) + away * (2 * random.uniform_double() - 1);
    // Multiples of 2^-53 below 1: differences have 53 bits, products 106, and 113 bits hold the determinant exactly.
    return {a, b, glm::clamp(glm::dvec2(c), 0.5, 1 - 0x1p-53)};
}

}

Knob measure_orientation(Means& means)
{
    constexpr std::uint64_t seed = 22;
    const int count = means.quick ? 20'000 : 500'000;
    Study study = study_of("orientation", "On which side of a line?",
                           fmt::format("{} points near a line through two others, one in ten within a rounding of it; "
                                       "the sign of the determinant against the exact one, which 113 bits hold. "
                                       "Seed {}.",
                                       count, seed),
                           "ns per test", {{"wrong", "wrong sides", "%"}});
    const std::vector<std::pair<std::string, int (*)(const Corners&)>> tests = {{"float", side_of<float>},
                                                                                {"double", side_of<double>},
                                                                                {"double, filtered", filtered},
                                                                                {"113 bits", side_of<Wide>}};
    for (const auto& [name, test] : tests) {
        Random random(seed);
        int wrong = 0;
        std::vector<Corners> timed;
        for (int i = 0; i < count; ++i) {
            const Corners corners = random_corners(random);
            wrong += test(corners) != side_of<Wide>(corners) ? 1 : 0;
            if (i < 2000) timed.push_back(corners);
        }
        study.trials.push_back({name, "", 0, {{"wrong", 100.0 * wrong / count}}, 2000, [timed, test = test] {
                                    for (const Corners& corners : timed) keep(test(corners));
                                }});
    }
    return finish(std::move(study), means);
}

}
