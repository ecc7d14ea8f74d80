// Prints how often the reference and the naive form differ from the oracle: the table in the statement of
// texturing/lookup. Usage: lookup-accuracy [SEED [LOOKUPS]]

#include <cstdio>
#include <cstdlib>
#include <texturing/support.hpp>

#include "../solution.hpp"

using namespace umbral;
using namespace umbral::texturing;
using Lookup = glm::vec4(const Grid<glm::vec4>&, const Sampler&, glm::vec2);

namespace {

// Up in steps of one and down again: all neighbours differ by one, the last and the first, too, so that errors count in
// texels.
Grid<glm::vec4> ruler(int count)
{
    Grid<glm::vec4> texture(count, 1);
    for (int i = 0; i < count; ++i) texture.at(i, 0) = glm::vec4(static_cast<float>(std::min(i, count - i)));
    return texture;
}

/// Percent of `lookups` coordinates of a size up to `reach` where the lookup is off by more than `allowed` texels.
double wrong(Lookup* lookup, Lookup* oracle, Filter filter, float reach, float allowed, std::uint64_t seed, int lookups)
{
    const Grid<glm::vec4> texture = ruler(300);
    const Sampler sampler{filter, Wrap::repeat, Wrap::repeat};
    Random random(seed);
    int count = 0;
    for (int i = 0; i < lookups; ++i) {
        const glm::vec2 uv(random.uniform(-reach, reach), 0.5F);
        count += std::abs(lookup(texture, sampler, uv).x - oracle(texture, sampler, uv).x) > allowed ? 1 : 0;
    }
    return 100.0 * count / lookups;
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int lookups = count > 2 ? std::atoi(arguments[2]) : 300'000;
    Lookup* const oracle = tests::solution<Lookup>(ORACLE_MODULE);
    std::printf("seed %llu, %d coordinates in [-reach, reach), 300 texels, repeated; percent wrong\n",
                static_cast<unsigned long long>(seed), lookups);
    std::printf("%-12s %-26s", "solution", "filter");
    constexpr float reaches[] = {1, 10, 1e2F, 1e3F, 1e4F, 1e5F, 1e6F};
    for (const float reach : reaches) std::printf(" %9.0f", double{reach});
    std::printf("\n");
    for (const auto& [name, module] :
         {std::pair{"reference", REFERENCE_MODULE}, {"u * n first", FLOAT_PRODUCT_MODULE}}) {
        Lookup* const lookup = tests::solution<Lookup>(module);
        for (const Filter filter : both_filters) {
            const bool blends = filter == Filter::bilinear;
            std::printf("%-12s %-26s", name, blends ? "bilinear: off by > 1e-3" : "nearest: another texel");
            for (const float reach : reaches)
                std::printf(" %9.4f", wrong(lookup, oracle, filter, reach, blends ? 1e-3F : 0, seed, lookups));
            std::printf("\n");
        }
    }
}
