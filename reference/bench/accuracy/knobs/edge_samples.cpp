#include <fmt/format.h>

#include "../sampled_study.hpp"

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
    const SamplePattern low_discrepancy = {"low-discrepancy", [](int count, Random& random) {
                                               const double x = random.uniform_double();
                                               return hammersley(count, {x, random.uniform_double()});
                                           }};
    add_sampled_trials(study, {independent_pattern(), stratified_pattern(), low_discrepancy}, seed, edges,
                       {[](Random& random, const auto& points) {
                            const HalfPlane edge = random_edge(random, 0, turn);
                            return covered_share(edge, points()) - covered_area(edge);
                        },
                        [](int, Random& random, const auto& points) {
                            const HalfPlane edge = random_edge(random, 0, turn);
                            return covered_share(edge, points());
                        }});
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
