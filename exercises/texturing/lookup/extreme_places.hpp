#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "../support.hpp"

/// Places where a coordinate or its product with the size is at the end of what a float can hold.
namespace umbral::texturing {

/// A float of any size, of either sign: just beside 0, or far out.
inline float any_size(Random& random, int kind)
{
    const float power = kind == 0   ? random.uniform(-30, -9)
                        : kind == 1 ? random.uniform(7, 12)
                        : kind == 2 ? random.uniform(17, 38)
                                    : random.uniform(2, 6);
    const float size = std::pow(10.0F, power);
    return random.below(2) == 0 ? -size : size;
}

/// A long way from 0 the fraction has few bits left, and a product with the size has none to spare; just below 0 it
/// rounds up to 1. The largest have no fraction left.
inline std::vector<Query> far_repeats(Random& random)
{
    std::vector<Query> queries;
    for (int i = 0; i < 600; ++i) {
        const Sampler sampler{both_filters[random.below(2)], Wrap::repeat, Wrap::repeat};
        const float u = any_size(random, i % 6);
        queries.push_back({random.below(2), sampler, {u, any_size(random, i % 6)}});
    }
    return queries;
}

/// As far out, but clamped, along one axis or both: all of these are edges. No whole number of 32 or 64 bits holds most
/// of them, or what they are times the size.
inline std::vector<Query> far_clamps(Random& random)
{
    std::vector<Query> queries;
    for (int i = 0; i < 240; ++i) {
        const std::uint32_t far_axis = random.below(3);  // u, v, or both
        Sampler sampler{both_filters[random.below(2)], random_wrap(random), random_wrap(random)};
        glm::vec2 uv(0.1F + 0.8F * random.uniform(), 0);
        uv.y = 0.1F + 0.8F * random.uniform();
        for (const auto& [axis, wrap] : {std::pair(0U, &sampler.wrap_u), {1U, &sampler.wrap_v}}) {
            if (far_axis != axis && far_axis != 2) continue;
            *wrap = Wrap::clamp_to_edge;
            uv[static_cast<int>(axis)] = any_size(random, std::array{1, 2, 1, 2, 0, 3}[i % 6]);
        }
        queries.push_back({random.below(2), sampler, uv});
    }
    return queries;
}

/// The smallest float u with u * count at `texel` or above it, and the largest below: a product in float rounds both
/// onto the border. In double it is exact.
inline std::pair<float, float> beside_border(int texel, int count)
{
    auto above = static_cast<float>(static_cast<double>(texel) / count);
    if (static_cast<double>(above) * count < texel) above = std::nextafter(above, 2.0F);
    return {std::nextafter(above, 0.0F), above};
}

/// Both sides of the borders of texture 0, each way, and of tables of many texels: texture 1 is a row and 2 a column.
inline std::vector<Query> border_places(Random& random, const std::array<int, 3>& counts)
{
    std::vector<Query> queries;
    const auto nearest = [&] { return Sampler{Filter::nearest, random_wrap(random), random_wrap(random)}; };
    for (int i = 1; i < counts[0]; ++i) {
        const auto above = static_cast<float>(i / static_cast<double>(counts[0]));
        const float below = std::nextafter(above, 0.0F);
        queries.push_back({0, nearest(), i % 2 == 0 ? glm::vec2(above, below) : glm::vec2(below, above)});
    }
    for (int i = 0; i < 160; ++i) {
        const std::size_t texture = 1 + random.below(2);
        const int count = counts[texture];
        const auto texel = 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(count - 1)));
        const auto [below, above] = beside_border(texel, count);
        const float along = i % 4 == 0 ? above : below;
        queries.push_back({texture, nearest(), texture == 1 ? glm::vec2(along, 0.5F) : glm::vec2(0.5F, along)});
    }
    return queries;
}

/// Well inside the texels of a row of 16,384, in every other question one of the first two, which lie within a
/// ten-thousandth of the edge.
inline std::vector<Query> long_row_places(Random& random, std::size_t texture)
{
    std::vector<Query> queries;
    for (int i = 0; i < 48; ++i) {
        const auto texel = static_cast<double>(i % 2 == 0 ? random.below(2) : random.below(16384));
        const auto u = static_cast<float>((texel + 0.25 + 0.5 * random.uniform_double()) / 16384);
        queries.push_back({texture, {Filter::nearest, random_wrap(random), random_wrap(random)}, {u, 0.5F}});
    }
    return queries;
}

}
