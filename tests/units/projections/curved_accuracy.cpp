// Prints how well small angles are known: the table in the statement of projections/curved.
// Usage: curved-accuracy [SEED [PAIRS]]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <umbral/core/random.hpp>

#include "../solution.hpp"
#include "curved_functions.hpp"

using namespace umbral;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int pairs = count > 2 ? std::atoi(arguments[2]) : 20'000;
    const CurvedFunctions& reference = *tests::solution_table<CurvedFunctions>(REFERENCE_MODULE);
    const CurvedFunctions& oracle = *tests::solution_table<CurvedFunctions>(ORACLE_MODULE);
    std::printf("seed %llu, %d pairs a line, worst errors relative to the angle\n",
                static_cast<unsigned long long>(seed), pairs);
    for (const float aside : {1e-1F, 1e-2F, 1e-3F, 1e-4F, 1e-5F, 1e-6F}) {
        Random random(seed);
        double in_float = 0;
        double in_double = 0;
        double in_reference = 0;
        for (int i = 0; i < pairs; ++i) {
            const glm::vec3 a = random.unit_vector();
            const glm::vec3 b = a + aside * random.uniform(1, 2) * random.unit_vector();
            const double exact = oracle.angle(a, b);
            if (exact < 0.5 * aside) continue;
            const float narrow = std::acos(std::min(1.0F, dot(normalize(a), normalize(b))));
            const double wide = std::acos(std::min(1.0, dot(normalize(glm::dvec3(a)), normalize(glm::dvec3(b)))));
            in_float = std::max(in_float, std::abs(narrow / exact - 1));
            in_double = std::max(in_double, std::abs(wide / exact - 1));
            in_reference = std::max(in_reference, std::abs(reference.angle(a, b) / exact - 1));
        }
        std::printf("| %.0e | %.1e | %.1e | %.1e |\n", aside, in_float, in_double, in_reference);
    }
}
