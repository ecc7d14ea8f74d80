// Prints the largest error of v near a pole: the table in the statement of texturing/coordinates.
// Usage: coordinates-accuracy [SEED [DIRECTIONS]]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <umbral/core/random.hpp>
#include <umbral/texturing/coordinates.hpp>

#include "../solution.hpp"

using namespace umbral;
using Spherical = glm::vec2(const glm::vec3&);

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int directions = count > 2 ? std::atoi(arguments[2]) : 100'000;
    const auto oracle = tests::solution<Spherical>(ORACLE_MODULE);
    std::printf("seed %llu, %d directions; largest error of v at a distance from the pole\n",
                static_cast<unsigned long long>(seed), directions);
    for (const auto& [name, module] :
         {std::pair{"reference", REFERENCE_MODULE}, {"arc sine in float", ARC_SINE_IN_FLOAT_MODULE}}) {
        const auto spherical = tests::solution<Spherical>(module);
        std::printf("%-20s", name);
        for (const float distance : {1.0F, 1e-1F, 1e-2F, 1e-3F, 1e-4F}) {
            Random random(seed);
            float largest = 0;
            for (int i = 0; i < directions; ++i) {
                const float longitude = random.uniform(-3.1F, 3.1F);
                const float off = distance * random.uniform(0.5F, 1);
                const float flat = std::sin(off);
                const glm::vec3 point(flat * std::cos(longitude), std::cos(off), flat * std::sin(longitude));
                largest = std::max(largest, std::abs(spherical(point).y - oracle(point).y));
            }
            std::printf(" %9.1e", double{largest});
        }
        std::printf("\n");
    }
}
