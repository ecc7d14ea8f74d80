#include "render/textures.hpp"

#include <cmath>
#include <cstdint>

#include "render/patterns.hpp"

namespace umbral::render {
namespace {

/// A texel's place in the texture: cells counted from the lower left corner, and how far it is into its cell.
struct Place {
    int column;
    int row;
    glm::vec2 uv;
    glm::vec2 in_cell;  ///< in [0, 1)
};

Place place_of(const scene::Texture& texture, int x, int y_from_below)
{
    const auto cell = [&](int i) { return static_cast<int>(std::int64_t{i} * texture.cells / texture.size); };
    const glm::vec2 uv = (glm::vec2(x, y_from_below) + 0.5F) / static_cast<float>(texture.size);
    return {cell(x), cell(y_from_below), uv, glm::fract(uv * static_cast<float>(texture.cells))};
}

// The hue goes once round with u, and the colour gets darker and lighter again with v, so that copies join without a
// seam; cells are alternately lighter and darker, and their borders white.
glm::vec3 uv_grid(const Place& place)
{
    constexpr float turn = 6.2831853F;
    constexpr float border = 0.03F;
    const glm::vec2 from_border = glm::min(place.in_cell, 1.0F - place.in_cell);
    if (from_border.x < border || from_border.y < border) return glm::vec3(0.9F);
    const float shade =
        ((place.column + place.row) % 2 == 0 ? 1.0F : 0.6F) * (0.8F - 0.2F * std::cos(turn * place.uv.y));
    return shade * (0.36F + 0.34F * glm::cos(turn * (place.uv.x + glm::vec3(0, 0.36F, 0.68F))));
}

glm::vec3 color_at(const scene::Texture& texture, const Place& place)
{
    switch (texture.kind) {
        case scene::TextureKind::checker: return (place.column + place.row) % 2 == 0 ? texture.first : texture.second;
        case scene::TextureKind::stripes: return place.column % 2 == 0 ? texture.first : texture.second;
        case scene::TextureKind::wood: return wood(texture, place.uv);
        case scene::TextureKind::marble: return marble(texture, place.uv);
        case scene::TextureKind::bricks: return bricks(texture, place.uv);
        case scene::TextureKind::pores: return pores(texture, place.uv);
        case scene::TextureKind::uv_grid: break;
    }
    return uv_grid(place);
}

}

Grid<glm::vec4> make_texture(const scene::Texture& texture)
{
    Grid<glm::vec4> texels(texture.size, texture.size);
    for (int y = 0; y < texture.size; ++y)
        for (int x = 0; x < texture.size; ++x)
            texels.at(x, y) = glm::vec4(color_at(texture, place_of(texture, x, texture.size - 1 - y)), 1);
    return texels;
}

}
