#include <cmath>
#include <umbral/texturing/mipmap.hpp>

// Levels as means of the texture's own texels in double, logarithms by the exponent and a rest, in long double.

namespace umbral::texturing {
namespace {

float level(long double ratio)
{
    int exponent = 0;
    const long double rest = std::frexp(ratio, &exponent);  // in [1/2, 1)
    const long double result = exponent + std::log2(rest);
    return result > 0 ? static_cast<float>(result) : 0;
}

}

Mipmap build_mipmap(const Grid<glm::vec4>& texture)
{
    Mipmap levels;
    for (int size = texture.width; size >= 1; size /= 2) {
        const int block = texture.width / size;
        Grid<glm::vec4> mean(size, size);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                glm::dvec4 sum(0);
                for (int k = 0; k < block * block; ++k)
                    sum += glm::dvec4(texture.at(x * block + k % block, y * block + k / block));
                mean.at(x, y) = glm::vec4(sum / static_cast<double>(block * block));
            }
        levels.push_back(mean);
    }
    return levels;
}

float level_at_distance(float distance, float near)
{
    return level(static_cast<long double>(distance) / static_cast<long double>(near));
}

float level_of_step(glm::vec2 by_x, glm::vec2 by_y, glm::ivec2 size)
{
    const auto steps = [&](glm::vec2 by) {
        return std::hypot(static_cast<long double>(by.x) * size.x, static_cast<long double>(by.y) * size.y);
    };
    const long double step = std::fmax(steps(by_x), steps(by_y));
    return step > 1 ? level(step) : 0;
}

glm::vec4 trilinear(const Mipmap& mipmap, glm::vec2 uv, float level)
{
    const Sampler blended{Filter::bilinear, Wrap::repeat, Wrap::repeat};
    const auto last = static_cast<double>(mipmap.size() - 1);
    const double between = std::fmin(std::fmax(static_cast<double>(level), 0.0), last);
    glm::dvec4 sum(0);
    for (std::size_t i = 0; i < mipmap.size(); ++i) {
        const double weight = 1 - std::fabs(between - static_cast<double>(i));
        if (weight > 0) sum += weight * glm::dvec4(lookup(mipmap[i], blended, uv));
    }
    return glm::vec4(sum);
}

}
