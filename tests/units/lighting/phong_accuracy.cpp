// Prints the largest error of highlights by their exponent: the table in the statement of lighting/phong.
// Usage: phong-accuracy [SEED [CASES]]

#include <cstdio>
#include <cstdlib>
#include <lighting/highlights.hpp>

#include "../solution.hpp"
#include "phong_functions.hpp"

using namespace umbral;
using namespace umbral::lighting;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int cases = count > 2 ? std::atoi(arguments[2]) : 20'000;
    const auto& oracle = *tests::solution<Phong>(ORACLE_MODULE);
    std::printf(
        "seed %llu, %d viewers up to 1.5 / sqrt(e) off the mirrored direction; largest error of the highlight\n",
        static_cast<unsigned long long>(seed), cases);
    for (const auto& [name, module] : {std::pair{"reference", REFERENCE_MODULE}, {"float", IN_FLOAT_MODULE}}) {
        const auto& unit = *tests::solution<Phong>(module);
        std::printf("%-10s", name);
        for (const float e : {1.0F, 10.0F, 100.0F, 1000.0F, 10'000.0F}) {
            Random random(seed);
            double worst = 0;
            for (int i = 0; i < cases; ++i) {
                const Glance g = random_glance(random, e, e);
                worst = std::max(worst, std::abs(double{unit.phong_highlight(g.normal, g.l, g.v, g.e)} -
                                                 double{oracle.phong_highlight(g.normal, g.l, g.v, g.e)}));
            }
            std::printf("  %7.1e", worst);
        }
        std::printf("\n");
    }
}
