// Prints how far the reference and the textbook in float lie from the oracle: the tables in the statement of
// transforms/axis-rotation. Usage: axis-rotation-accuracy [SEED [TURNS]]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <transforms/support.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "axis_rotation_table.hpp"

using namespace umbral;
using namespace umbral::transforms;

namespace {

glm::dmat3 rotation_of(const glm::mat4& matrix) { return glm::dmat3(glm::dmat4(matrix)); }

template <class Entry>
double largest(Entry entry)
{
    double worst = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) worst = std::max(worst, entry(column, row));
    return worst;
}

/// The largest entry of MᵀM - I.
double off_orthonormal(const glm::mat4& matrix)
{
    const glm::dmat3 rest = transpose(rotation_of(matrix)) * rotation_of(matrix) - glm::dmat3(1);
    return largest([&](int column, int row) { return std::abs(rest[column][row]); });
}

/// The worst entry, each by itself, in ulps.
double worst_ulps(const glm::mat4& got, const glm::mat4& exact)
{
    return largest([&](int column, int row) { return tests::ulps_between(got[column][row], exact[column][row]); });
}

double worst_difference(const glm::mat4& got, const glm::mat4& exact)
{
    return largest(
        [&](int column, int row) { return std::abs(double{got[column][row]} - double{exact[column][row]}); });
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int turns = count > 2 ? std::atoi(arguments[2]) : 20'000;
    const tests::Rotations oracle = *tests::solution<const tests::Rotations>(ORACLE_MODULE);
    std::printf("seed %llu, %d tiny turns a line\n", static_cast<unsigned long long>(seed), turns);
    for (const auto& [name, module] : {std::pair{"reference", REFERENCE_MODULE}, {"in float", IN_FLOAT_MODULE}}) {
        const tests::Rotations rotate = *tests::solution<const tests::Rotations>(module);
        for (const float angle : {1.0F, 1e-1F, 1e-2F, 1e-3F, 1e-4F, 1e-5F, 1e-6F, 1e-8F}) {
            Random random(seed);
            double worst = 0;
            for (int i = 0; i < turns; ++i) {
                const AxisAngle turn{clear_axis(i % 2 == 0, random), angle * random.uniform(0.5F, 1)};
                worst = std::max(worst, worst_ulps(rotate.matrix(turn), oracle.matrix(turn)));
            }
            std::printf("%-10s angle %7.0e: worst entry %8.2g ulp\n", name, double{angle}, worst);
        }
        const std::vector<AxisAngle> steady(3'600'000, {{1, -2, 2}, 1e-4F});
        for (const std::size_t steps :
             {std::size_t{1000}, std::size_t{10'000}, std::size_t{100'000}, std::size_t{1'000'000}, steady.size()}) {
            const auto chain = std::span(steady).first(steps);
            const glm::mat4 matrix = rotate.chain(chain);
            std::printf("%-10s %8zu turns of 1e-4: worst entry %8.2g, off orthonormal %8.2g\n", name, steps,
                        worst_difference(matrix, oracle.chain(chain)), off_orthonormal(matrix));
        }
    }
}
