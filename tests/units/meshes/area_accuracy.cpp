// Prints how far three ways to compute areas lie from the oracle: the tables in the statement of meshes/area.
// Usage: area-accuracy [SEED [TRIANGLES]]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <meshes/zoo.hpp>

#include "../solution.hpp"
#include "area_table.hpp"

using namespace umbral;
using namespace umbral::meshes;

namespace {

double relative_error(float got, float exact) { return std::abs(double{got} - double{exact}) / double{exact}; }

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int triangles = count > 2 ? std::atoi(arguments[2]) : 200'000;
    const tests::Areas oracle = *tests::solution<const tests::Areas>(ORACLE_MODULE);
    std::printf("seed %llu, %d triangles a line, largest relative error\n", static_cast<unsigned long long>(seed),
                triangles);
    for (const auto& [name, module] :
         {std::pair{"in float", IN_FLOAT_MODULE}, {"Heron in double", HERON_MODULE}, {"reference", REFERENCE_MODULE}}) {
        const tests::Areas areas = *tests::solution<const tests::Areas>(module);
        for (const double sine : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
            Random random(seed);
            const IndexedMesh slivers = sliver_triangles(sine, triangles, random);
            double worst = 0;
            for (const glm::uvec3& t : slivers.triangles) {
                const auto area = [&](const tests::Areas& solution) {
                    return solution.triangle(slivers.positions[t.x], slivers.positions[t.y], slivers.positions[t.z]);
                };
                worst = std::max(worst, relative_error(area(areas), area(oracle)));
            }
            std::printf("%-16s sine %5.0e: %7.1g\n", name, sine, worst);
        }
        for (const std::uint32_t columns : {100U, 316U, 1000U, 3162U}) {
            const IndexedMesh mesh = torus(columns, columns / 2);
            std::printf("%-16s torus of %zu triangles: %7.1g\n", name, mesh.triangles.size(),
                        relative_error(areas.mesh(mesh), oracle.mesh(mesh)));
        }
    }
}
