// Prints how often the normal is wrong with tangents of several lengths: the table in the statement of texturing/bump.
// Usage: bump-accuracy [SEED [FRAMES]]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <umbral/core/random.hpp>
#include <umbral/texturing/bump.hpp>

using namespace umbral;
using namespace umbral::texturing;

namespace {

using Normal = glm::vec3(const glm::vec3&, const Tangents&, glm::vec2);

// As it is often written: products of floats.
glm::vec3 naive(const glm::vec3& n, const Tangents& tangents, glm::vec2 slopes)
{
    const float side = dot(cross(tangents.u, tangents.v), n);
    if (side == 0) return n;
    const glm::vec3 raised = cross(tangents.u + slopes.x * n, tangents.v + slopes.y * n);
    return normalize(side < 0 ? -raised : raised);
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int frames = count > 2 ? std::atoi(arguments[2]) : 100'000;
    std::printf("seed %llu, %d frames; percent off by more than 1e-5\n", static_cast<unsigned long long>(seed), frames);
    for (const auto& [name, normal] :
         {std::pair<const char*, Normal*>{"reference", &bumped_normal}, {"products in float", &naive}}) {
        std::printf("%-20s", name);
        for (const double size : {1e-30, 1e-20, 1.0, 1e20, 1e30}) {
            Random random(seed);
            int wrong = 0;
            for (int i = 0; i < frames; ++i) {
                const glm::vec3 n = random.unit_vector();
                const glm::dvec3 side =
                    normalize(cross(glm::dvec3(n), std::abs(n.x) < 0.6F ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
                const double skew = random.uniform(-1, 1);
                const double d_u = random.uniform(-1, 1);
                const double d_v = random.uniform(-1, 1);
                // In a frame of unit tangents the gradient of the height follows without any product of lengths.
                const glm::dvec3 front = cross(glm::dvec3(n), side);
                const glm::dvec3 expected = normalize(glm::dvec3(n) - d_u * side - (d_v - skew * d_u) * front);
                const Tangents tangents{size * side, size * (front + skew * side)};
                const glm::dvec3 actual = normal(n, tangents, glm::vec2(size * d_u, size * d_v));
                wrong += distance(actual, expected) <= 1e-5 ? 0 : 1;
            }
            std::printf(" %9.3f", 100.0 * wrong / frames);
        }
        std::printf("\n");
    }
}
