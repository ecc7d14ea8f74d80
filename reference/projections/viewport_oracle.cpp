#include <umbral/projections/viewport.hpp>

#include <wide.hpp>

// With 113 bits, and whole numbers for the pixels: they are found by bisection of the borders instead of by rounding.

namespace umbral::projections {
namespace {

/// Which of `count` cells of [-1, 1) it lies in; -1 if in none.
int cell(float ndc, int count)
{
    if (!(ndc >= -1 && ndc < 1)) return -1;
    int low = 0;
    int high = count;  // the border k lies at 2 k / count - 1
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (Wide(ndc) * count >= Wide(2) * middle - count ? low : high) = middle;
    }
    return low;
}

Wide between(Wide low, Wide size, Wide share) { return low + size * share; }

}

glm::mat4 viewport_matrix(const Viewport& v)
{
    const Wide half(0.5);
    const Wide depth = Wide(v.far_depth) - v.near_depth;
    glm::mat4 matrix(1);
    matrix[0][0] = static_cast<float>(half * v.width);
    matrix[1][1] = static_cast<float>(half * v.height);
    matrix[2][2] = static_cast<float>(half * depth);
    matrix[3] = {static_cast<float>(between(v.left, v.width, half)),
                 static_cast<float>(between(v.bottom, v.height, half)),
                 static_cast<float>(between(v.near_depth, depth, half)), 1};
    return matrix;
}

glm::vec3 ndc_from_window(const Viewport& v, const glm::vec3& window)
{
    const Wide depth = Wide(v.far_depth) - v.near_depth;
    return {static_cast<float>(between(-1, 2, (Wide(window.x) - v.left) / v.width)),
            static_cast<float>(between(-1, 2, (Wide(window.y) - v.bottom) / v.height)),
            static_cast<float>(between(-1, 2, (Wide(window.z) - v.near_depth) / depth))};
}

std::optional<glm::ivec2> pixel_at(const Viewport& v, const glm::vec2& ndc)
{
    const glm::ivec2 found(cell(ndc.x, v.width), cell(ndc.y, v.height));
    if (found.x < 0 || found.y < 0) return std::nullopt;
    return glm::ivec2(v.left, v.bottom) + found;
}

glm::vec2 pixel_centre(const Viewport& v, const glm::ivec2& pixel)
{
    const Wide half(0.5);
    return {static_cast<float>(between(-1, 2, (pixel.x - v.left + half) / v.width)),
            static_cast<float>(between(-1, 2, (pixel.y - v.bottom + half) / v.height))};
}

}
