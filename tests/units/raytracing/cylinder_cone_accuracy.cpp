// Prints how many pairs each form gets wrong: the table in the statement of raytracing/cylinder-cone.
// Usage: cylinder-cone-accuracy [SEED [PAIRS]]

#include <array>
#include <cstdio>
#include <cstdlib>
#include <raytracing/cylinder-cone/shots.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "cylinder_cone_functions.hpp"

using namespace umbral;
using namespace umbral::raytracing;

namespace {

struct Errors {
    int wrong = 0;     ///< pairs of which one answer is a hit for a miss, or a miss for a hit
    double worst = 0;  ///< error of t where both hit, in ulps
};

std::optional<float> answer(const char* module, Quadric quadric, const Ray& ray)
{
    const auto& functions = *tests::solution_table<CylinderConeFunctions>(module);
    return quadric == Quadric::cylinder ? functions.intersect_cylinder(ray) : functions.intersect_cone(ray);
}

Errors errors_of(const char* module, Quadric quadric, const std::vector<Ray>& rays)
{
    Errors errors;
    for (std::size_t i = 0; i < rays.size(); i += 2) {
        bool wrong = false;
        for (const Ray& ray : {rays[i], rays[i + 1]}) {
            const std::optional<float> got = answer(module, quadric, ray);
            const std::optional<float> exact = answer(ORACLE_MODULE, quadric, ray);
            wrong = wrong || got.has_value() != exact.has_value();
            if (got && exact) errors.worst = std::max(errors.worst, tests::ulps_between(*got, *exact));
        }
        errors.wrong += wrong ? 1 : 0;
    }
    return errors;
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int pairs = count > 2 ? std::atoi(arguments[2]) : 20'000;
    std::printf("seed %llu, %d pairs a column: wrong pairs in %%, worst t in ulp\n",
                static_cast<unsigned long long>(seed), pairs);
    std::printf("%-22s%18s%18s%18s%18s%18s%18s\n", "", "random", "open ends", "1e3 away", "1e4 away", "1e5 away",
                "nearly parallel");
    for (const Quadric quadric : {Quadric::cylinder, Quadric::cone}) {
        Random random(seed);
        const std::array<std::vector<Ray>, 6> columns = {
            random_pairs(quadric, random, pairs),   open_pairs(quadric, random, pairs),
            far_pairs(quadric, random, 1e3, pairs), far_pairs(quadric, random, 1e4, pairs),
            far_pairs(quadric, random, 1e5, pairs), nearly_parallel_pairs(quadric, random, pairs)};
        for (const auto& [name, module] :
             {std::pair<const char*, const char*>{"float", IN_FLOAT_MODULE}, {"reference", REFERENCE_MODULE}}) {
            std::printf("%-9s %-12s", quadric == Quadric::cylinder ? "cylinder" : "cone", name);
            for (const std::vector<Ray>& rays : columns) {
                const Errors errors = errors_of(module, quadric, rays);
                std::printf("%8.2f %% %7.0f", 100.0 * errors.wrong / pairs, errors.worst);
            }
            std::printf("\n");
        }
    }
}
