// Prints how far points land from where they should, for windows ever narrower beside the axis: the table in the
// statement of projections/frustum. Usage: frustum-accuracy [SEED [POINTS]]

#include <cstdio>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>

#include "../solution.hpp"
#include "frustum_functions.hpp"

using namespace umbral;

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int points = count > 2 ? std::atoi(arguments[2]) : 100'000;
    const Frustum& reference = *tests::solution_table<Frustum>(REFERENCE_MODULE);
    const Frustum& oracle = *tests::solution_table<Frustum>(ORACLE_MODULE);
    std::printf("seed %llu, %d points a line, worst errors of x against the oracle\n",
                static_cast<unsigned long long>(seed), points);
    for (const float share : {1e-1F, 1e-2F, 1e-3F, 1e-4F, 1e-5F}) {
        Random random(seed);
        double in_float = 0;
        double in_reference = 0;
        for (int i = 0; i < points; ++i) {
            const float left = random.uniform(2, 5);
            const float right = left * (1 + share);
            const glm::mat4 projection = glm::frustum(left, right, -1.0F, 1.0F, 1.0F, 100.0F);
            const float distance = random.uniform(1, 50);
            const glm::vec3 point(distance * glm::mix(left, right, random.uniform()), 0, -distance);
            const double exact = oracle.point(projection, point).value().x;
            const glm::vec4 clip = projection * glm::vec4(point, 1);
            in_float = std::max(in_float, std::abs(clip.x / clip.w - exact));
            in_reference = std::max(in_reference, std::abs(reference.point(projection, point).value().x - exact));
        }
        std::printf("window of %.0e of its distance: in float %.2g, reference %.2g\n", share, in_float, in_reference);
    }
}
