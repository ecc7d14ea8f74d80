#include <fmt/format.h>

#include <cmath>

#include "../samples.hpp"
#include "../study.hpp"

namespace umbral::bench {
namespace {

constexpr double right_angle = 1.5707963267948966;
constexpr double tilt = 1e-3;

/// A lattice turned by the golden ratio: no two points share a row or a column.
std::vector<glm::dvec2> lattice(int count)
{
    std::vector<glm::dvec2> points;
    for (int i = 0; i < count; ++i) points.emplace_back(glm::fract((i + 0.5) * 0.6180339887498949), (i + 0.5) / count);
    return points;
}

}

Knob measure_edge_patterns(Means& means)
{
    constexpr std::uint64_t seed = 12;
    const int edges = means.quick ? 2000 : 40'000;
    Study study = study_of("edge-patterns", "Edges: grid or turned",
                           fmt::format("Edges that are nearly level (within 1/1000 rad), the worst case of a "
                                       "regular grid: {} of them, sampled by a grid and by a turned lattice of "
                                       "as many points, against the exact area; seed {}.",
                                       edges, seed),
                           "ns per pixel", {{"rms", "error of the coverage, RMS", "of a pixel"}});
    for (const bool turned : {false, true})
        for (const int count : {1, 4, 16, 64, 144}) {
            const std::vector<glm::dvec2> points = turned ? lattice(count) : cells(count, nullptr);
            Random random(seed);
            std::vector<double> errors;
            std::vector<HalfPlane> timed;
            for (int i = 0; i < edges; ++i) {
                const HalfPlane edge = random_edge(random, right_angle - tilt, right_angle + tilt);
                errors.push_back(covered_share(edge, points) - covered_area(edge));
                if (i < 512) timed.push_back(edge);
            }
            const std::string family = turned ? "turned" : "grid";
            study.trials.push_back({fmt::format("{} {}", family, count),
                                    family,
                                    static_cast<double>(count),
                                    {{"rms", root_mean_square(errors)}},
                                    512,
                                    [points, timed] {
                                        for (const HalfPlane& edge : timed) keep(covered_share(edge, points));
                                    }});
        }
    study.laws = {
        {"grid", "rms", "samples", -0.5, "A level edge sees √N rows only.", "A tilt parts the points of a row."},
        {"turned", "rms", "samples", -1, "Every point has a row of its own: N rows.",
         "A tilt makes rows of unequal height."}};
    return finish(std::move(study), means);
}

}
