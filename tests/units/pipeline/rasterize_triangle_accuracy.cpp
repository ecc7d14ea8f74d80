// Prints how many needles the reference and edge functions in float get wrong, and how far off weights are in large
// triangles: the table in the statement of pipeline/rasterize-triangle. Usage: rasterize-triangle-accuracy [SEED
// [TRIANGLES]]

#include <cstdio>
#include <cstdlib>
#include <pipeline/support.hpp>

#include "../solution.hpp"

using namespace umbral;
using namespace umbral::pipeline;
using Rasterize = void(const Triangle&, int, int, std::vector<Fragment>&);

namespace {

constexpr int width = 40;
constexpr int height = 24;

struct Errors {
    std::size_t expected = 0;
    std::size_t missing = 0;
    std::size_t extra = 0;
    double worst_weight = 0;  ///< absolute, of the fragments that both have
};

void add(Errors& errors, const std::vector<Fragment>& got, const std::vector<Fragment>& exact)
{
    Grid<const Fragment*> seen(width, height, nullptr);
    for (const Fragment& fragment : got) seen.at(fragment.pixel.x, fragment.pixel.y) = &fragment;
    std::size_t common = 0;
    for (const Fragment& fragment : exact) {
        const Fragment* const same = seen.at(fragment.pixel.x, fragment.pixel.y);
        if (same == nullptr) continue;
        ++common;
        const glm::vec3 error = abs(same->weights - fragment.weights);
        errors.worst_weight = std::max(errors.worst_weight, double{std::max(error.x, std::max(error.y, error.z))});
    }
    errors.expected += exact.size();
    errors.missing += exact.size() - common;
    errors.extra += got.size() - common;
}

/// Triangles of about `reach` pixels with one side exactly through two centres in the picture.
Triangle aimed(Random& random, float reach)
{
    const Aim aim = random_aim(random, width, height);
    const float steps = std::max(1.0F, std::min(steps_inside(aim, 1), std::floor(reach / length(aim.step))));
    const glm::vec2 a = aim.centre + steps * aim.step;
    const glm::vec2 b = aim.centre - steps * aim.step;
    const auto side = static_cast<int>(reach);
    const float x = on_grid(random, -side, side, 256);
    return random_attributes(random, shuffled(random, {a, b, glm::vec2(x, on_grid(random, -side, side, 256))}));
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int triangles = count > 2 ? std::atoi(arguments[2]) : 20'000;
    Rasterize* const oracle = tests::solution<Rasterize>(ORACLE_MODULE);
    std::printf("seed %llu, %d needles and as many large triangles a line, w from 1 to 8, picture %d x %d\n",
                static_cast<unsigned long long>(seed), triangles, width, height);
    std::printf("%-12s %8s %24s %24s %14s\n", "solution", "reach", "pixels of needles lost, %", "pixels too many, %",
                "worst weight");
    for (const auto& [name, module] : {std::pair{"reference", REFERENCE_MODULE}, {"float edges", FLOAT_EDGES_MODULE}}) {
        Rasterize* const rasterize = tests::solution<Rasterize>(module);
        for (const int reach : {16, 64, 256, 1024, 4096, 16000}) {
            Random random(seed);
            Errors needles;
            Errors large;
            const auto compare = [&](Errors& errors, const Triangle& triangle) {
                std::vector<Fragment> got;
                std::vector<Fragment> exact;
                rasterize(triangle, width, height, got);
                oracle(triangle, width, height, exact);
                add(errors, got, exact);
            };
            for (int i = 0; i < triangles; ++i) {
                compare(needles, random_attributes(random, needle(random, width, height, reach, i % 2 == 0)));
                compare(large, aimed(random, static_cast<float>(reach)));
            }
            const auto percent = [&](std::size_t part) {
                return 100.0 * static_cast<double>(part) / static_cast<double>(needles.expected);
            };
            std::printf("%-12s %8d %24.3f %24.3f %14.2g\n", name, reach, percent(needles.missing),
                        percent(needles.extra), large.worst_weight);
        }
    }
}
