#include <fmt/format.h>

#include "../samples.hpp"
#include "../study.hpp"

namespace umbral::bench {

Knob measure_edge_samples(Means& means)
{
    constexpr std::uint64_t seed = 11;
    constexpr double turn = 6.283185307179586;
    const int edges = means.quick ? 400 : 4000;
    Study study = study_of("edge-samples", "Samples a pixel",
                           fmt::format("The part of a pixel that {} random edges cover, from points that are "
                                       "independent, one in each cell of a grid, or Hammersley's with a random "
                                       "shift, against the exact area; seed {}.",
                                       edges, seed),
                           "ns per pixel", {{"rms", "error of the coverage, RMS", "of a pixel"}});
    using Pattern = std::vector<glm::dvec2> (*)(int, Random&);
    const std::vector<std::pair<std::string, Pattern>> patterns = {
        {"random", [](int count, Random& random) { return independent(count, random); }},
        {"stratified", [](int count, Random& random) { return cells(count, &random); }},
        {"low-discrepancy", [](int count, Random& random) {
             const double x = random.uniform_double();
             return hammersley(count, {x, random.uniform_double()});
         }}};
    for (const auto& [family, pattern] : patterns)
        for (const int count : {1, 4, 16, 64, 256}) {
            Random random(seed);
            std::vector<double> errors;
            for (int i = 0; i < edges; ++i) {
                const HalfPlane edge = random_edge(random, 0, turn);
                errors.push_back(covered_share(edge, pattern(count, random)) - covered_area(edge));
            }
            study.trials.push_back({fmt::format("{} {}", family, count),
                                    family,
                                    static_cast<double>(count),
                                    {{"rms", root_mean_square(errors)}},
                                    16,
                                    [count, pattern = pattern] {
                                        Random again(seed);
                                        for (int i = 0; i < 16; ++i)
                                            keep(covered_share(random_edge(again, 0, turn), pattern(count, again)));
                                    }});
        }
    study.laws = {
        {"random", "rms", "samples", -0.5, "The variance of a mean of independent samples is 1/N.", ""},
        {"stratified", "rms", "samples", -0.75,
         "Only the √N cells on the edge err, each by 1/N: the variance is √N / N².",
         "With few cells most lie on the edge."},
        {"low-discrepancy", "rms", "samples", -0.75, "An edge at an angle to the axes is met like by a jittered grid.",
         "Edges near the axes are met better, and few points leave no room for the limit."}};
    return finish(std::move(study), means);
}

}
