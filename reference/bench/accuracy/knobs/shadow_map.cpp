#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <umbral/core/grid.hpp>
#include <umbral/core/random.hpp>

#include "../study.hpp"

namespace umbral::bench {
namespace {

/// A ball of radius ½ over the ground z = 0; light comes along `down`; the map's plane is spanned by u and v.
const glm::dvec3 centre(0, 0, 0.8);
const glm::dvec3 down = normalize(glm::dvec3(1, 0.4, -1.2));
const glm::dvec3 u = normalize(cross(down, glm::dvec3(0, 0, 1)));
const glm::dvec3 v = cross(u, down);
constexpr double reach = 3;  // the map shows [-reach, reach] in u and v

/// Depth along the light of the ball on the ray at (a, b); infinite if it passes.
double ball_depth(double a, double b)
{
    const double x = a - dot(centre, u);
    const double y = b - dot(centre, v);
    const double rest = 0.25 - x * x - y * y;
    return rest < 0 ? std::numeric_limits<double>::infinity() : dot(centre, down) - std::sqrt(rest);
}

double ground_depth(double a, double b) { return -(a * u.z + b * v.z) / down.z; }

using Map = Grid<float>;

Map draw_map(int size)
{
    Map map(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double a = reach * ((2 * x + 1.0) / size - 1);
            const double b = reach * ((2 * y + 1.0) / size - 1);
            map.at(x, y) = static_cast<float>(std::min(ball_depth(a, b), ground_depth(a, b)));
        }
    return map;
}

bool is_dark(const Map& map, const glm::dvec3& point, double bias)
{
    const auto texel = [&](double along) { return static_cast<int>((along / reach + 1) / 2 * map.width); };
    return double{map.at(texel(dot(point, u)), texel(dot(point, v)))} + bias < dot(point, down);
}

}

Knob measure_shadow_map(Means& means)
{
    constexpr std::uint64_t seed = 29;
    Random random(seed);
    std::vector<glm::dvec3> points;
    for (int i = 0; i < (means.quick ? 20'000 : 200'000); ++i) {
        const double x = 3 * random.uniform_double() - 1;
        points.emplace_back(x, 2 * random.uniform_double() - 1, 0);
    }
    Study study = study_of("shadow-map", "Shadow map: size and bias",
                           fmt::format("A ball's shadow on slanted ground, by maps of n × n texels: of {} points, the "
                                       "share on the wrong side, against the exact shadow; seed {}. The bias is none, "
                                       "fixed, or as large as the ground's slope asks for within a texel. The time is "
                                       "that of drawing the map and looking up 20 000 points.",
                                       points.size(), seed),
                           "ms per frame", {{"wrong", "points wrongly lit or dark", "%"}}, 1e3);
    // How fast the ground's depth changes along the map, times the farthest that a point lies from its texel's middle.
    const double slope = (std::abs(u.z) + std::abs(v.z)) / std::abs(down.z);
    for (const std::string family : {"no bias", "bias 0.02", "slope bias"})
        for (const int size : {32, 64, 128, 256, 512}) {
            const double bias = family == "no bias" ? 0 : family == "bias 0.02" ? 0.02 : 1.01 * slope * reach / size;
            const Map map = draw_map(size);
            int wrong = 0;
            for (const glm::dvec3& point : points) {
                const bool dark = ball_depth(dot(point, u), dot(point, v)) < dot(point, down);
                wrong += is_dark(map, point, bias) != dark ? 1 : 0;
            }
            study.trials.push_back({fmt::format("{}, {}", family, size),
                                    family,
                                    static_cast<double>(size),
                                    {{"wrong", 100.0 * wrong / static_cast<double>(points.size())}},
                                    1,
                                    [size, bias, &points] {
                                        const Map drawn = draw_map(size);
                                        for (std::size_t i = 0; i < 20'000; ++i) keep(is_dark(drawn, points[i], bias));
                                    }});
        }
    study.laws = {
        {"slope bias", "wrong", "texels a side", -1,
         "Wrong are points within a texel of the shadow's edge: a strip as wide as a texel.",
         "In coarse maps the bias also lets light in where the ball is near the ground."},
        {"no bias", "wrong", "texels a side", 0,
         "Half of each texel of slanted ground lies behind its middle and darkens itself, however small.", ""}};
    return finish(std::move(study), means);
}

}
