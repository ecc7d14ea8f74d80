// Prints the relative error of grazing light: the table in the statement of lighting/diffuse-ambient.
// Usage: diffuse-ambient-accuracy [SEED [CASES]]

#include <cstdio>
#include <cstdlib>
#include <lighting/random.hpp>
#include <vector>

#include "../solution.hpp"
#include "diffuse_ambient_functions.hpp"

using namespace umbral;
using namespace umbral::lighting;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int cases = count > 2 ? std::atoi(arguments[2]) : 20'000;
    const auto& oracle = *tests::solution<DiffuseAmbient>(ORACLE_MODULE);
    std::printf("seed %llu, %d cases a column: points within 100, lamps 20 to 200 away; relative error of the light\n",
                static_cast<unsigned long long>(seed), cases);
    std::printf("%-22s", "cosine");
    for (int power = 1; power <= 6; ++power) std::printf("    10^-%d", power);
    const Material white{{}, {}, glm::vec3(1)};
    for (const auto& [name, module] : {std::pair{"reference", REFERENCE_MODULE}, {"float", IN_FLOAT_MODULE}}) {
        const auto& unit = *tests::solution<DiffuseAmbient>(module);
        for (const double quantile : {0.5, 1.0}) {
            std::printf("\n%-10s %-11s", name, quantile < 1 ? "median" : "largest");
            for (int power = 1; power <= 6; ++power) {
                Random random(seed);
                std::vector<double> errors;
                for (int i = 0; i < cases; ++i) {
                    const SurfacePoint at{100.0F * random.in_cube(), random.unit_vector()};
                    const glm::vec3 aside = normalize(cross(at.normal, random.unit_vector()));
                    const float cosine = std::pow(10.0F, static_cast<float>(-power));
                    const std::vector<Light> lamp = {
                        light_towards(at, aside + cosine * at.normal, true, random.uniform(20, 200))};
                    const float exact = oracle.matt_reflection(at, white, lamp, glm::vec3(0)).x;
                    // Rounded places may turn the lamp behind the surface.
                    if (exact < 0.1F * cosine) continue;
                    const float got = unit.matt_reflection(at, white, lamp, glm::vec3(0)).x;
                    errors.push_back(std::abs(double{got} - double{exact}) / double{exact});
                }
                std::sort(errors.begin(), errors.end());
                const auto place = static_cast<std::size_t>(quantile * static_cast<double>(errors.size() - 1));
                std::printf("  %7.1e", errors[place]);
            }
        }
    }
    std::printf("\n");
}
