// Prints how far the reference and the textbook in float lie from the oracle: the tables in the statement of
// meshes/vertex-normals. Usage: vertex-normals-accuracy [SEED [TRIANGLES]]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <meshes/support.hpp>

#include "../solution.hpp"
#include "vertex_normals_table.hpp"

using namespace umbral;
using namespace umbral::meshes;

namespace {

/// The largest angle between two lists of unit vectors, in radians; 2 where one is zero, or not finite, and the other
/// is not.
double worst_angle(const std::vector<glm::vec3>& got, const std::vector<glm::vec3>& exact)
{
    double worst = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double chord = distance(glm::dvec3(got[i]), glm::dvec3(exact[i]));
        const bool comparable = std::isfinite(chord) && (got[i] == glm::vec3(0)) == (exact[i] == glm::vec3(0));
        worst = std::max(worst, comparable ? 2 * std::asin(std::min(1.0, chord / 2)) : 2);
    }
    return worst;
}

/// How many differ by 1e-3 or more, or are not finite.
int far_off(const std::vector<glm::vec3>& got, const std::vector<glm::vec3>& exact)
{
    int count = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
        count += distance(glm::dvec3(got[i]), glm::dvec3(exact[i])) < 1e-3 ? 0 : 1;
    return count;
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int triangles = count > 2 ? std::atoi(arguments[2]) : 200'000;
    const tests::Normals oracle = *tests::solution<const tests::Normals>(ORACLE_MODULE);
    std::printf("seed %llu, %d triangles or folds a line, largest angle to the oracle's normal in radians\n",
                static_cast<unsigned long long>(seed), triangles);
    for (const auto& [name, module] : {std::pair{"reference", REFERENCE_MODULE}, {"in float", IN_FLOAT_MODULE}}) {
        const tests::Normals normals = *tests::solution<const tests::Normals>(module);
        for (const double sine : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
            Random random(seed);
            const IndexedMesh slivers = sliver_triangles(sine, triangles, random);
            const IndexedMesh folds = sharp_folds(std::max(sine, 1e-5), triangles, random);
            std::printf("%-10s sine or angle %7.0e: slivers %8.2g, folds %8.2g\n", name, sine,
                        worst_angle(normals.faces(slivers), oracle.faces(slivers)),
                        worst_angle(normals.vertices(folds), oracle.vertices(folds)));
        }
        for (const float scale : {1e-36F, 1e-13F, 1e-12F, 1e-11F, 1e-10F, 1.0F, 1e9F, 1e10F, 1e11F, 1e36F}) {
            Random random(seed);
            int wrong = 0;
            int all = 0;
            for (int i = 0; i < 40; ++i) {
                const IndexedMesh mesh =
                    mapped(hills(12, 12, random), [&](const glm::vec3& position) { return scale * position; });
                wrong += far_off(normals.faces(mesh), oracle.faces(mesh));
                all += static_cast<int>(mesh.triangles.size());
            }
            std::printf("%-10s edges of 1 to 5 times %7.0e: %5.1f %% of the faces are off by 1e-3 or more\n", name,
                        double{scale}, 100.0 * wrong / all);
        }
    }
}
