// Based on: L. Williams. Pyramidal Parametrics. SIGGRAPH 1983; The OpenGL Graphics System, version 4.5, section 8.14.

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <string>
#include <umbral/texturing/mipmap.hpp>

namespace umbral::texturing {
namespace {

Grid<glm::vec4> halved(const Grid<glm::vec4>& fine)
{
    Grid<glm::vec4> coarse(fine.width / 2, fine.height / 2);
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x) {
            const glm::vec4 upper = fine.at(2 * x, 2 * y) + fine.at(2 * x + 1, 2 * y);
            const glm::vec4 lower = fine.at(2 * x, 2 * y + 1) + fine.at(2 * x + 1, 2 * y + 1);
            coarse.at(x, y) = (upper + lower) / 4.0F;
        }
    return coarse;
}

}

Mipmap build_mipmap(const Grid<glm::vec4>& texture)
{
    if (texture.width != texture.height || !std::has_single_bit(static_cast<unsigned>(texture.width)))
        throw std::invalid_argument("build_mipmap: expected a square of 2^n x 2^n texels, got " +
                                    std::to_string(texture.width) + " x " + std::to_string(texture.height));
    Mipmap levels = {texture};
    while (levels.back().width > 1) levels.push_back(halved(levels.back()));
    return levels;
}

float level_at_distance(float distance, float near)
{
    return static_cast<float>(std::max(0.0, std::log2(double{distance} / near)));
}

float level_of_step(glm::vec2 by_x, glm::vec2 by_y, glm::ivec2 size)
{
    const glm::dvec2 texels(size);
    const double step = std::max(length(texels * glm::dvec2(by_x)), length(texels * glm::dvec2(by_y)));
    return static_cast<float>(std::log2(std::max(step, 1.0)));
}

glm::vec4 trilinear(const Mipmap& mipmap, glm::vec2 uv, float level)
{
    constexpr Sampler blended{Filter::bilinear, Wrap::repeat, Wrap::repeat};
    const auto last = static_cast<float>(mipmap.size() - 1);
    const float between = std::clamp(level, 0.0F, last);
    const float finer = std::floor(between);
    const float coarser = std::min(finer + 1, last);
    return mix(lookup(mipmap[static_cast<std::size_t>(finer)], blended, uv),
               lookup(mipmap[static_cast<std::size_t>(coarser)], blended, uv), between - finer);
}

}
