#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>
#include <utility>

#include "color.hpp"

/// Pictures as files hold them, from light, and from pictures drawn at twice their size.
namespace umbral {

/// The picture of linear light, opaque.
inline Image encoded(const Grid<glm::vec3>& linear)
{
    Image image(linear.width, linear.height);
    std::transform(linear.cells.begin(), linear.cells.end(), image.cells.begin(),
                   [](const glm::vec3& light) { return pixel_of(light); });
    return image;
}

/// Each pixel is the mean of 2 x 2: edges without steps.
inline Image halved(const Image& picture)
{
    Image result(picture.width / 2, picture.height / 2);
    for (int y = 0; y < result.height; ++y) {
        for (int x = 0; x < result.width; ++x) {
            glm::uvec4 sum(2);
            for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
                sum += glm::uvec4(picture.at(2 * x + dx, 2 * y + dy));
            result.at(x, y) = glm::u8vec4(sum / 4U);
        }
    }
    return result;
}

}
