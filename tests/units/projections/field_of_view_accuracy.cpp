// Prints the relative error of the cotangent of half the field of view, close to 180 degrees: the table in the
// statement of projections/field-of-view. Usage: field-of-view-accuracy [SEED [ANGLES]]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <umbral/core/random.hpp>

#include "../solution.hpp"
#include "field_of_view_functions.hpp"

using namespace umbral;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int angles = count > 2 ? std::atoi(arguments[2]) : 100'000;
    const FieldOfView& reference = *tests::solution_table<FieldOfView>(REFERENCE_MODULE);
    const FieldOfView& oracle = *tests::solution_table<FieldOfView>(ORACLE_MODULE);
    std::printf("seed %llu, %d angles a line, worst relative errors against the oracle\n",
                static_cast<unsigned long long>(seed), angles);
    for (const float rest : {90.0F, 1.0F, 0.1F, 0.01F, 0.001F, 0.0001F}) {
        Random random(seed);
        double in_float = 0;
        double in_reference = 0;
        for (int i = 0; i < angles; ++i) {
            const float fovy_degrees = 180 - rest * random.uniform(rest > 1 ? 0.1F : 0.7F, 1);
            const double exact = oracle.matrix({fovy_degrees, 1, 1, 2})[1][1];
            const float naive = 1 / std::tan(0.5F * fovy_degrees * 0.017453293F);
            in_float = std::max(in_float, std::abs(naive / exact - 1));
            in_reference =
                std::max(in_reference, std::abs(reference.matrix({fovy_degrees, 1, 1, 2})[1][1] / exact - 1));
        }
        std::printf("180 minus %.0e: in float %.2g, reference %.2g\n", rest, in_float, in_reference);
    }
}
