// alternative: recursion for the levels, half the logarithm of the square in double, and a bilinear lookup of its own
#include <cmath>
#include <stdexcept>
#include <umbral/texturing/mipmap.hpp>

namespace umbral::texturing {
namespace {

void add_levels(Mipmap& mipmap)
{
    const int size = mipmap.back().width / 2;
    if (size == 0) return;
    Grid<glm::vec4> next(size, size, glm::vec4(0));
    for (int y = 0; y < 2 * size; ++y)
        for (int x = 0; x < 2 * size; ++x) next.at(x / 2, y / 2) += mipmap.back().at(x, y);
    for (glm::vec4& texel : next.cells) texel *= 0.25F;
    mipmap.push_back(next);
    add_levels(mipmap);
}

glm::dvec4 blended(const Grid<glm::vec4>& level, glm::vec2 uv)
{
    const double x = (uv.x - std::floor(double{uv.x})) * level.width - 0.5;
    const double y = (uv.y - std::floor(double{uv.y})) * level.height - 0.5;
    const int i = static_cast<int>(std::floor(x));
    const int j = static_cast<int>(std::floor(y));
    const auto texel = [&](int column, int row) {
        const int wrapped = (row + level.height) % level.height;
        return glm::dvec4(level.at((column + level.width) % level.width, level.height - 1 - wrapped));
    };
    const double s = x - i;
    const double t = y - j;
    return (1 - s) * (1 - t) * texel(i, j) + s * (1 - t) * texel(i + 1, j) + (1 - s) * t * texel(i, j + 1) +
           s * t * texel(i + 1, j + 1);
}

}

Mipmap build_mipmap(const Grid<glm::vec4>& texture)
{
    int power = 1;
    while (power < texture.width) power *= 2;
    if (texture.width != power || texture.height != power) throw std::invalid_argument("size");
    Mipmap mipmap = {texture};
    add_levels(mipmap);
    return mipmap;
}

float level_at_distance(float distance, float near)
{
    if (distance <= near) return 0;
    return static_cast<float>(std::log(static_cast<double>(distance) / static_cast<double>(near)) / std::log(2.0));
}

float level_of_step(glm::vec2 by_x, glm::vec2 by_y, glm::ivec2 size)
{
    const glm::dvec2 a = glm::dvec2(by_x) * glm::dvec2(size);
    const glm::dvec2 b = glm::dvec2(by_y) * glm::dvec2(size);
    const double square = std::max(dot(a, a), dot(b, b));
    return square > 1 ? static_cast<float>(0.5 * std::log2(square)) : 0;
}

glm::vec4 trilinear(const Mipmap& mipmap, glm::vec2 uv, float level)
{
    const double between = std::min(std::max(double{level}, 0.0), static_cast<double>(mipmap.size()) - 1);
    const auto lower = static_cast<std::size_t>(between);
    const std::size_t upper = std::min(lower + 1, mipmap.size() - 1);
    const double s = between - static_cast<double>(lower);
    return glm::vec4((1 - s) * blended(mipmap[lower], uv) + s * blended(mipmap[upper], uv));
}

}
