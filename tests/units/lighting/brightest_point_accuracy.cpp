// Prints the largest error of a highlight's place by the height of light and eye above the sphere: the table in the
// statement of lighting/brightest-point. Usage: brightest-point-accuracy [SEED [CASES]]

#include <cstdio>
#include <cstdlib>
#include <lighting/brightest-point/lit_sphere.hpp>

#include "../solution.hpp"
#include "brightest_point_functions.hpp"

using namespace umbral;
using namespace umbral::lighting;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int cases = count > 2 ? std::atoi(arguments[2]) : 20'000;
    const auto& oracle = *tests::solution<BrightestPoint>(ORACLE_MODULE);
    std::printf(
        "seed %llu, %d spheres at the origin; largest error of brightest_specular in radii; in brackets of "
        "brightest_seen\n",
        static_cast<unsigned long long>(seed), cases);
    for (const auto& [name, module] : {std::pair{"reference", REFERENCE_MODULE}, {"float", IN_FLOAT_MODULE}}) {
        const auto& unit = *tests::solution<BrightestPoint>(module);
        std::printf("%-10s", name);
        for (const float height : {1.0F, 0.1F, 0.01F, 0.001F}) {
            Random random(seed);
            float worst = 0;
            float worst_seen = 0;
            const auto error = [](const std::optional<glm::vec3>& one, const std::optional<glm::vec3>& other) {
                return one && other ? length(*one - *other) : one.has_value() == other.has_value() ? 0.0F : 2.0F;
            };
            for (int i = 0; i < cases; ++i) {
                const LitSphere q = lit_sphere(random, {}, random.uniform(0.1F, 0.9F), 1 + height, 1 + height);
                worst = std::max(worst, error(unit.brightest_specular(q.sphere, q.light, q.eye),
                                              oracle.brightest_specular(q.sphere, q.light, q.eye)));
                worst_seen = std::max(worst_seen, error(unit.brightest_seen(q.sphere, q.light, q.eye),
                                                        oracle.brightest_seen(q.sphere, q.light, q.eye)));
            }
            std::printf("  %7.1e (%7.1e)", double{worst}, double{worst_seen});
        }
        std::printf("\n");
    }
}
