// Prints the relative error of the window of a sphere, from ever nearer: the table in the statement of
// projections/fit-frustum. Usage: fit-frustum-accuracy [SEED [SPHERES]]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <umbral/core/random.hpp>

#include "../solution.hpp"
#include "fit_frustum_functions.hpp"

using namespace umbral;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int spheres = count > 2 ? std::atoi(arguments[2]) : 100'000;
    const Fit& reference = *tests::solution_table<Fit>(REFERENCE_MODULE);
    const Fit& oracle = *tests::solution_table<Fit>(ORACLE_MODULE);
    std::printf("seed %llu, %d spheres a line, worst relative errors against the oracle\n",
                static_cast<unsigned long long>(seed), spheres);
    for (const float above : {1.0F, 1e-2F, 1e-4F, 1e-6F}) {
        Random random(seed);
        double in_float = 0;
        double in_reference = 0;
        for (int i = 0; i < spheres; ++i) {
            const float radius = random.uniform(0.5F, 5);
            const float distance = radius * (1 + above * random.uniform(0.8F, 1.2F));
            if (!(distance > radius)) continue;
            const double exact = oracle.sphere(radius, distance, {1, 1}).top;
            const float naive = (distance - radius) * radius / std::sqrt(distance * distance - radius * radius);
            in_float = std::max(in_float, std::isfinite(naive) ? std::abs(naive / exact - 1) : INFINITY);
            in_reference = std::max(in_reference, std::abs(reference.sphere(radius, distance, {1, 1}).top / exact - 1));
        }
        std::printf("%.0e radii above: squares in float %.2g, reference %.2g\n", above, in_float, in_reference);
    }
}
