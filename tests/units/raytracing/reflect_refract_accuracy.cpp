// Prints the errors of each form: the table in the statement of raytracing/reflect-refract.
// Usage: reflect-refract-accuracy [SEED [RAYS]]

#include <cstdio>
#include <cstdlib>
#include <raytracing/reflect-refract/glances.hpp>

#include "../solution.hpp"
#include "reflect_refract_functions.hpp"

using namespace umbral;
using namespace umbral::raytracing;

namespace {

struct Errors {
    int wrong = 0;     ///< answers that are none where there is one, or the other way round
    double worst = 0;  ///< of a coordinate
};

Errors errors_of(const char* module, const std::vector<SurfaceGlance>& glances)
{
    const auto& functions = *tests::solution_table<ReflectRefractFunctions>(module);
    const auto& oracle = *tests::solution_table<ReflectRefractFunctions>(ORACLE_MODULE);
    Errors errors;
    for (const SurfaceGlance& g : glances) {
        const auto got = functions.refracted(g.v, g.n, g.outside, g.inside);
        const auto exact = oracle.refracted(g.v, g.n, g.outside, g.inside);
        errors.wrong += got.has_value() != exact.has_value() ? 1 : 0;
        if (!got || !exact) continue;
        for (int i = 0; i < 3; ++i)
            errors.worst = std::max(errors.worst, std::abs(double{(*got)[i]} - double{(*exact)[i]}));
    }
    return errors;
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int rays = count > 2 ? std::atoi(arguments[2]) : 20'000;
    std::printf("seed %llu, %d rays a column: total reflection told wrong in %%, worst coordinate\n",
                static_cast<unsigned long long>(seed), rays);
    Random random(seed);
    std::vector<std::vector<SurfaceGlance>> columns(1);
    for (int i = 0; i < rays; ++i) columns[0].push_back(refracted_glance(random));
    std::printf("%-12s%20s", "", "random");
    for (const double near : {1e-3, 1e-5, 1e-7, 1e-9}) {
        std::printf("%19s%.0e", "cos² ", near);
        columns.emplace_back();
        for (int i = 0; i < rays; ++i) columns.back().push_back(critical_glance(i % 2 == 0 ? near : -near, random));
    }
    std::printf("\n");
    for (const auto& [name, module] :
         {std::pair<const char*, const char*>{"float", IN_FLOAT_MODULE}, {"reference", REFERENCE_MODULE}}) {
        std::printf("%-12s", name);
        for (const std::vector<SurfaceGlance>& glances : columns) {
            const Errors errors = errors_of(module, glances);
            std::printf("%10.2f %% %11.1e", 100.0 * errors.wrong / rays, errors.worst);
        }
        std::printf("\n");
    }
}
