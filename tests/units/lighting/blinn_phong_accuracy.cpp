// Prints how wide Blinn's and Phong's highlights are, and what is left of the sum of nearly opposite vectors: the
// tables in the statement of lighting/blinn-phong. Usage: blinn-phong-accuracy [SEED [CASES]]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <lighting/highlights.hpp>

#include "../solution.hpp"
#include "blinn_phong_functions.hpp"

using namespace umbral;
using namespace umbral::lighting;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int cases = count > 2 ? std::atoi(arguments[2]) : 20'000;
    const auto& oracle = *tests::solution<BlinnPhong>(ORACLE_MODULE);
    const glm::vec3 up(0, 0, 1);
    std::printf("half of the highlight is left at so many degrees off its middle, with l = n\n%-10s", "e");
    constexpr float exponents[] = {5, 20, 80, 320};
    for (const float e : exponents) std::printf(" %9g", double{e});
    for (const int factor : {0, 1, 4}) {
        std::printf("\n%-10s", factor == 0 ? "Phong e" : factor == 1 ? "Blinn e" : "Blinn 4e");
        for (const float e : exponents) {
            double low = 0;
            double high = 1.5;
            for (int i = 0; i < 50; ++i) {
                const double angle = 0.5 * (low + high);
                const glm::vec3 v(std::sin(angle), 0, std::cos(angle));
                const double highlight = factor == 0
                                             ? std::pow(std::cos(angle), e)
                                             : oracle.blinn_highlight(up, up, v, static_cast<float>(factor) * e);
                (highlight > 0.5 ? low : high) = angle;
            }
            std::printf(" %9.1f", glm::degrees(low));
        }
    }
    std::printf("\nseed %llu, %d cases a column; largest error of h by the angle between l and -v\n",
                static_cast<unsigned long long>(seed), cases);
    for (const auto& [name, module] : {std::pair{"reference", REFERENCE_MODULE}, {"float", IN_FLOAT_MODULE}}) {
        const auto& unit = *tests::solution<BlinnPhong>(module);
        std::printf("%-10s", name);
        for (const float angle : {1e-2F, 1e-3F, 1e-4F, 1e-5F, 1e-6F}) {
            Random random(seed);
            double worst = 0;
            for (int i = 0; i < cases; ++i) {
                const glm::vec3 l = random.unit_vector();
                const glm::vec3 v = angle * normalize(cross(l, random.unit_vector())) - l;
                const glm::vec3 exact = oracle.half_vector(l, v).value_or(glm::vec3(0));
                const glm::vec3 got = unit.half_vector(l, v).value_or(glm::vec3(0));
                worst = std::max(worst, double{length(got - exact)});
            }
            std::printf("  %7.1e", worst);
        }
        std::printf("\n");
    }
}
