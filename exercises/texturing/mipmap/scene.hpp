#pragma once

#include <kit/picture.hpp>
#include <string>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/texturing/mipmap.hpp>

#include "../support.hpp"

/// The goal picture of texturing/mipmap: a tiled hall that runs to the horizon, on the left without mipmaps and on the
/// right with them.
namespace umbral::texturing {

/// Where a ray meets the hall -1 <= x <= 1, -1 <= y <= 1, which runs along -z, seen from the origin.
struct HallPoint {
    glm::vec2 uv{0};
    float distance = 0;
    int wall = 0;  ///< 0 floor, 1 ceiling, 2 the sides
};

inline HallPoint hall_point(const glm::vec3& direction)
{
    const float to_side = 1 / std::max(std::abs(direction.x), 1e-6F);
    const float to_level = 0.8F / std::max(std::abs(direction.y), 1e-6F);
    const float t = std::min(to_side, to_level);
    const glm::vec3 place = t * direction;
    if (to_side < to_level) return {{2 * std::abs(place.z) / 2.4F, 0.5F + place.y * 0.5F / 0.8F}, t, 2};
    return {glm::vec2(place.x, place.z) * 1.5F, t, direction.y < 0 ? 0 : 1};
}

/// The side walls: a wainscot of tiles below whitewash, with a frieze.
inline Grid<glm::vec4> wall_texture(int size)
{
    const Grid<glm::vec4> tile = star_tile(size / 4);
    return painted(size, [&](glm::vec2 p) {
        const float height = 0.5F + 0.5F * p.y;
        const glm::vec3 lime(0.78F, 0.70F, 0.58F);
        if (height > 0.93F) return glm::vec3(0.28F, 0.13F, 0.05F);
        if (height > 0.5F) return lime;
        if (height > 0.45F) return std::sin(p.x * 50.27F) > 0 ? glm::vec3(0.02F, 0.1F, 0.36F) : lime;
        const glm::vec2 at = glm::fract(2.0F * (p + 1.0F)) * static_cast<float>(tile.width);
        return glm::vec3(tile.at(std::min(static_cast<int>(at.x), tile.width - 1),
                                 std::min(static_cast<int>(at.y), tile.height - 1)));
    });
}

/// Beams of dark wood.
inline Grid<glm::vec4> ceiling_texture(int size)
{
    return painted(size, [](glm::vec2 p) {
        const bool beam = std::abs(p.y) < 0.4F;
        const bool line = std::abs(std::abs(p.x) - 0.5F) < 0.06F;
        const glm::vec3 wood = beam ? glm::vec3(0.20F, 0.085F, 0.03F) : glm::vec3(0.40F, 0.20F, 0.08F);
        return beam && line ? glm::vec3(0.7F, 0.42F, 0.1F) : wood;
    });
}

/// One question, told in words: to note a mipmap for each pixel would take seconds. Varied, the eye looks elsewhere.
inline Image picture(Recorder& out, int width, int height, Variation vary = {})
{
    ask_in_words(out, [&] {
        return "// a hall, " + std::to_string(width) + " x " + std::to_string(height) +
               " pixels: build_mipmap for its three textures, level_of_step and trilinear for each pixel";
    });
    const Grid<glm::vec4> textures[] = {star_tile(128), ceiling_texture(128), wall_texture(256)};
    std::vector<Mipmap> mipmaps;
    for (const Grid<glm::vec4>& texture : textures) mipmaps.push_back(build_mipmap(texture));
    const glm::vec2 aside = vary.near(glm::vec2(0, -0.12F), 0.15F);
    const auto point_at = [&](float x, float y) {
        const glm::vec2 at = (glm::vec2(x, y) - 0.5F * glm::vec2(width, height)) / static_cast<float>(height);
        return hall_point({1.5F * at.x + aside.x, -1.5F * at.y + aside.y, -1});
    };
    Image image(width, height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const float x = static_cast<float>(column) + 0.5F;
            const float y = static_cast<float>(row) + 0.5F;
            const HallPoint here = point_at(x, y);
            const auto wall = static_cast<std::size_t>(here.wall);
            glm::vec3 color(0);
            if (2 * column < width) {
                color = lookup(textures[wall], {Filter::nearest, Wrap::repeat, Wrap::repeat}, here.uv);
            } else if (!mipmaps[wall].empty()) {
                const int size = textures[wall].width;
                const float level = level_of_step(point_at(x + 0.5F, y).uv - point_at(x - 0.5F, y).uv,
                                                  point_at(x, y + 0.5F).uv - point_at(x, y - 0.5F).uv, {size, size});
                color = trilinear(mipmaps[wall], here.uv, level);
            }
            // Light falls in at the far end, and from lamps every few steps.
            const float lamp = 0.5F + 0.5F * std::cos(1.4F * here.distance);
            const glm::vec3 light = glm::vec3(0.62F, 0.56F, 0.48F) + 0.35F * lamp * glm::vec3(1, 0.85F, 0.6F);
            const float haze = 1 - std::exp(-0.0012F * here.distance * here.distance);
            image.at(column, row) = pixel_of(mix(color * light, glm::vec3(0.95F, 0.88F, 0.74F), haze));
        }
    for (int row = 0; row < height; ++row) image.at(width / 2, row) = glm::u8vec4(255);
    return image;
}

}
