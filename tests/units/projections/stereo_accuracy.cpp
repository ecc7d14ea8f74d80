// Prints how well the parallax of points near the screen is known: the table in the statement of projections/stereo.
// Usage: stereo-accuracy [SEED [POINTS]]

#include <cstdio>
#include <cstdlib>
#include <umbral/core/random.hpp>

#include "../solution.hpp"
#include "stereo_functions.hpp"

using namespace umbral;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int points = count > 2 ? std::atoi(arguments[2]) : 100'000;
    const StereoFunctions& reference = *tests::solution_table<StereoFunctions>(REFERENCE_MODULE);
    const StereoFunctions& oracle = *tests::solution_table<StereoFunctions>(ORACLE_MODULE);
    std::printf("seed %llu, %d points a line, worst errors relative to the parallax\n",
                static_cast<unsigned long long>(seed), points);
    for (const float aside : {1e-1F, 1e-2F, 1e-3F, 1e-4F, 1e-5F}) {
        Random random(seed);
        double in_float = 0;
        double in_reference = 0;
        for (int i = 0; i < points; ++i) {
            const projections::StereoScreen screen{4, 3, random.uniform(0.5F, 9), random.uniform(0.05F, 0.5F), 1, 9};
            const float distance = screen.distance * (1 + aside * random.uniform(1, 2));
            const double exact = oracle.parallax(screen, distance);
            const float naive = screen.eye_separation - screen.eye_separation * screen.distance / distance;
            in_float = std::max(in_float, std::abs(naive / exact - 1));
            in_reference = std::max(in_reference, std::abs(reference.parallax(screen, distance) / exact - 1));
        }
        std::printf("| %.0e | %.1e | %.1e |\n", aside, in_float, in_reference);
    }
}
