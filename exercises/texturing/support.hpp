#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>
#include <umbral/core/random.hpp>
#include <umbral/texturing/lookup.hpp>
#include <vector>

/// What the drivers of texturing share: textures, and questions put to them.
namespace umbral::texturing {

/// One question: a texture's place in a list, how it is sampled, and where.
struct Query {
    std::size_t texture = 0;
    Sampler sampler;
    glm::vec2 uv{0};
};

inline constexpr std::array<Filter, 2> both_filters = {Filter::nearest, Filter::bilinear};
inline constexpr std::array<Wrap, 2> both_wraps = {Wrap::repeat, Wrap::clamp_to_edge};

/// Random colours: no two texels are alike, so that each answer tells which ones were read.
inline Grid<glm::vec4> random_texture(Random& random, int width, int height)
{
    Grid<glm::vec4> texture(width, height);
    for (glm::vec4& texel : texture.cells)
        for (int channel = 0; channel < 4; ++channel) texel[channel] = random.uniform();
    return texture;
}

inline Wrap random_wrap(Random& random) { return both_wraps[random.below(2)]; }

/// A coordinate in the lower half of one of `count` texels, 2 % of a texel from its border and its centre at least, up
/// to `turns` times round.
inline float inside_texel(Random& random, int count, int turns)
{
    const auto texel = static_cast<int>(random.below(static_cast<std::uint32_t>(count)));
    const int turn = static_cast<int>(random.below(static_cast<std::uint32_t>(2 * turns))) - turns;
    return static_cast<float>((texel + 0.02 + 0.46 * random.uniform_double()) / count + turn);
}

/// A texture from a function of its texels' centres, whose coordinates lie in (-1, 1), y up.
template <class Colour>
Grid<glm::vec4> painted(int size, Colour colour)
{
    Grid<glm::vec4> texture(size, size);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const glm::vec2 centre = (2.0F * glm::vec2(column, row) + 1.0F) / static_cast<float>(size) - 1.0F;
            texture.at(column, row) = glm::vec4(colour(glm::vec2(centre.x, -centre.y)), 1);
        }
    return texture;
}

/// A glazed tile as in the Alhambra: two squares make a star with eight points. Linear colours; `size` texels a side.
inline Grid<glm::vec4> star_tile(int size)
{
    return painted(size, [](glm::vec2 p) {
        const auto square = [](glm::vec2 q) { return std::max(std::abs(q.x), std::abs(q.y)); };
        const glm::vec2 turned = glm::vec2(p.x + p.y, p.y - p.x) * 0.70710678F;
        const float star = std::min(square(p), square(turned));
        const float heart = std::max(square(p), square(turned));
        if (heart < 0.22F) return glm::vec3(0.85F, 0.45F, 0.06F);
        if (heart < 0.36F) return glm::vec3(0.82F, 0.78F, 0.66F);
        if (star < 0.62F) return glm::vec3(0.02F, 0.1F, 0.36F);
        if (star < 0.75F) return glm::vec3(0.82F, 0.78F, 0.66F);
        return std::abs(p.x) + std::abs(p.y) > 1.5F ? glm::vec3(0.85F, 0.45F, 0.06F) : glm::vec3(0.03F, 0.3F, 0.27F);
    });
}

/// A band that climbs to the right, with a bead in it: mirrored or turned, it looks different.
inline Grid<glm::vec4> braid_tile(int size)
{
    return painted(size, [](glm::vec2 p) {
        const float across = p.y - p.x - 2 * std::floor((p.y - p.x + 1) / 2);  // in [-1, 1), periodic
        if (length(p - glm::vec2(0.1F, 0.1F)) < 0.33F) return glm::vec3(0.9F, 0.72F, 0.3F);
        if (std::abs(across) < 0.5F) return glm::vec3(0.55F, 0.05F, 0.04F);
        return std::abs(across) < 0.72F ? glm::vec3(0.85F, 0.6F, 0.15F) : glm::vec3(0.86F, 0.8F, 0.68F);
    });
}

}
