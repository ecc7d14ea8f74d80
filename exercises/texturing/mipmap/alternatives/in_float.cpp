// alternative: logarithms apart, in float; the mean of each block as a loop; one level where the fraction is 0
#include <cmath>
#include <stdexcept>
#include <umbral/texturing/mipmap.hpp>

namespace umbral::texturing {

Mipmap build_mipmap(const Grid<glm::vec4>& texture)
{
    const int n = texture.width;
    if (n < 1 || n != texture.height || (n & (n - 1)) != 0) throw std::invalid_argument("not 2^n x 2^n");
    Mipmap mipmap(1, texture);
    for (int size = n / 2; size > 0; size /= 2) {
        const Grid<glm::vec4> before = mipmap.back();
        Grid<glm::vec4> next(size, size);
        for (int i = 0; i < size * size; ++i) {
            glm::vec4 sum(0);
            for (int k = 0; k < 4; ++k) sum += 0.25F * before.at(2 * (i % size) + k % 2, 2 * (i / size) + k / 2);
            next.cells[static_cast<std::size_t>(i)] = sum;
        }
        mipmap.push_back(next);
    }
    return mipmap;
}

float level_at_distance(float distance, float near)
{
    const float level = std::log2(distance) - std::log2(near);
    return level < 0 ? 0 : level;
}

float level_of_step(glm::vec2 by_x, glm::vec2 by_y, glm::ivec2 size)
{
    const float along_x = std::hypot(by_x.x * static_cast<float>(size.x), by_x.y * static_cast<float>(size.y));
    const float along_y = std::hypot(by_y.x * static_cast<float>(size.x), by_y.y * static_cast<float>(size.y));
    const float step = std::max(along_x, along_y);
    if (step <= 1) return 0;
    return std::log2(step);
}

glm::vec4 trilinear(const Mipmap& mipmap, glm::vec2 uv, float level)
{
    const Sampler sampler{Filter::bilinear, Wrap::repeat, Wrap::repeat};
    const std::size_t last = mipmap.size() - 1;
    if (level <= 0) return lookup(mipmap.front(), sampler, uv);
    if (level >= static_cast<float>(last)) return lookup(mipmap.back(), sampler, uv);
    const auto i = static_cast<std::size_t>(level);
    const float s = level - static_cast<float>(i);
    const glm::vec4 fine = lookup(mipmap[i], sampler, uv);
    if (s == 0) return fine;
    return (1 - s) * fine + s * lookup(mipmap[i + 1], sampler, uv);
}

}
