// Prints the largest error of the level of a step: the table in the statement of texturing/mipmap.
// Usage: mipmap-accuracy [SEED [STEPS]]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <umbral/core/random.hpp>
#include <umbral/texturing/mipmap.hpp>

using namespace umbral;
using namespace umbral::texturing;

namespace {

constexpr int columns = 64;

// As it is often written: squares of floats.
float naive(glm::vec2 step) { return std::max(0.0F, std::log2(length(step * float{columns}))); }

float reference(glm::vec2 step) { return level_of_step(step, {0, 0}, {columns, columns}); }

long double exact(glm::vec2 step)
{
    const auto texels = [](float part) { return static_cast<long double>(part) * columns; };
    return std::fmax(0.0L, std::log2(std::hypot(texels(step.x), texels(step.y))));
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int steps = count > 2 ? std::atoi(arguments[2]) : 100'000;
    std::printf("seed %llu, %d steps of 2^e to 2^(e+1) texels; largest error of the level\n",
                static_cast<unsigned long long>(seed), steps);
    for (const auto& [name, level] : {std::pair{"reference", &reference}, {"squares in float", &naive}}) {
        std::printf("%-20s", name);
        for (const float exponent : {1.0F, 10.0F, 60.0F, 65.0F, 100.0F}) {
            Random random(seed);
            long double largest = 0;
            for (int i = 0; i < steps; ++i) {
                const float angle = random.uniform(0, 6.28F);
                const float length = (1 + random.uniform()) * std::exp2(exponent) / columns;
                const glm::vec2 step = length * glm::vec2(std::cos(angle), std::sin(angle));
                largest = std::max(largest, std::fabs(level(step) - exact(step)));
            }
            std::printf(" %9.1Le", largest);
        }
        std::printf("\n");
    }
}
