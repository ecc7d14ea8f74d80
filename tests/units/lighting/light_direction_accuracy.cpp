// Prints the largest error of latitudes near a pole: the table in the statement of lighting/light-direction.
// Usage: light-direction-accuracy [SEED [CASES]]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <umbral/core/random.hpp>

#include "../solution.hpp"
#include "light_direction_functions.hpp"

using namespace umbral;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int cases = count > 2 ? std::atoi(arguments[2]) : 20'000;
    const auto& oracle = *tests::solution<LightDirection>(ORACLE_MODULE);
    const auto& reference = *tests::solution<LightDirection>(REFERENCE_MODULE);
    std::printf("seed %llu, %d directions; largest error of the latitude in degrees\n",
                static_cast<unsigned long long>(seed), cases);
    for (const bool by_arc_sine : {false, true}) {
        std::printf("%-22s", by_arc_sine ? "arc sine in float" : "reference");
        for (const double off : {1e-1, 1e-2, 1e-3, 1e-4}) {
            Random random(seed);
            double worst = 0;
            for (int i = 0; i < cases; ++i) {
                const double angle = random.uniform(0, 6.28F);
                const double away = off * random.uniform(1, 1.5F);
                const glm::vec3 d(away * std::sin(angle), 1, away * std::cos(angle));
                const float found =
                    by_arc_sine ? glm::degrees(std::asin(normalize(d).y)) : reference.light_angles(d).latitude_degrees;
                worst = std::max(worst, std::abs(double{found} - double{oracle.light_angles(d).latitude_degrees}));
            }
            std::printf("  %7.1e", worst);
        }
        std::printf("\n");
    }
}
