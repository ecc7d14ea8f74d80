#pragma once

#include <algorithm>
#include <vector>

#include "model.hpp"

namespace umbral::bench::scenes {

/// A texture's levels, the finest first, each half as wide and high as the one before; one level where it has no
/// mipmaps. Levels are rounded to eight bits, as those of OpenGL are.
inline std::vector<Image> level_images(const Texture& texture)
{
    std::vector<Image> levels = {texture.texels};
    while (texture.mipmaps && (levels.back().width > 1 || levels.back().height > 1)) {
        const Image& fine = levels.back();
        Image coarse(std::max(fine.width / 2, 1), std::max(fine.height / 2, 1));
        for (int y = 0; y < coarse.height; ++y)
            for (int x = 0; x < coarse.width; ++x) {
                const int right = std::min(2 * x + 1, fine.width - 1);
                const int below = std::min(2 * y + 1, fine.height - 1);
                const glm::uvec4 sum = glm::uvec4(fine.at(2 * x, 2 * y)) + glm::uvec4(fine.at(right, 2 * y)) +
                                       glm::uvec4(fine.at(2 * x, below)) + glm::uvec4(fine.at(right, below));
                coarse.at(x, y) = glm::u8vec4((sum + 2U) / 4U);
            }
        levels.push_back(coarse);
    }
    return levels;
}

/// The same, from 0 to 1.
inline std::vector<Grid<glm::vec4>> mipmaps(const Texture& texture)
{
    std::vector<Grid<glm::vec4>> levels;
    for (const Image& image : level_images(texture)) {
        Grid<glm::vec4> level(image.width, image.height);
        for (std::size_t i = 0; i < level.cells.size(); ++i) level.cells[i] = glm::vec4(image.cells[i]) / 255.0F;
        levels.push_back(level);
    }
    return levels;
}

}
