// Prints how far the reference and the textbook in float lie from the oracle: the tables in the statement of
// projections/view-matrix. Usage: view-matrix-accuracy [SEED [CAMERAS]]

#include <cstdio>
#include <cstdlib>
#include <projections/support.hpp>

#include "../solution.hpp"
#include "../view_errors.hpp"

using namespace umbral;
using namespace umbral::projections;
using View = glm::mat4(const glm::vec3&, const glm::vec3&, const glm::vec3&);

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int cameras = count > 2 ? std::atoi(arguments[2]) : 200'000;
    View* const oracle = tests::solution<View>(ORACLE_MODULE);
    const std::pair<const char*, View*> solutions[] = {{"reference", tests::solution<View>(REFERENCE_MODULE)},
                                                       {"in float", tests::solution<View>(FLOAT_CROSS_MODULE)}};
    std::printf("seed %llu, %d cameras a line, worst errors against the oracle\n",
                static_cast<unsigned long long>(seed), cameras);

    for (const auto& [name, view_matrix] : solutions) {
        for (const double sine : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 2e-6}) {
            Random random(seed);
            double rotation = 0;
            for (int i = 0; i < cameras; ++i) {
                const Placement c = with_up_near_view(random_placement(random), sine, i % 2 == 1, random);
                rotation = std::max(
                    rotation, tests::rotation_error(view_matrix(c.eye, c.target, c.up), oracle(c.eye, c.target, c.up)));
            }
            std::printf("%-10s sine of up to view %7.0e: rotation %.2g\n", name, sine, rotation);
        }
        for (const double far : {1e0, 1e2, 1e4, 1e6}) {
            Random random(seed);
            double rotation = 0;
            double translation = 0;
            for (int i = 0; i < cameras; ++i) {
                Placement c = random_placement(random);
                c.eye = static_cast<float>(far) * random.unit_vector();
                c.target = glm::vec3(0);
                if (sine_to_up(c) < 0.17) continue;
                const glm::mat4 got = view_matrix(c.eye, c.target, c.up);
                const glm::mat4 exact = oracle(c.eye, c.target, c.up);
                rotation = std::max(rotation, tests::rotation_error(got, exact));
                translation = std::max(translation, tests::translation_error(got, exact));
            }
            std::printf("%-10s eye at %7.0e: rotation %.2g, translation %.2g world units\n", name, far, rotation,
                        translation);
        }
    }
}
