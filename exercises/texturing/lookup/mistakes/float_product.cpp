// mistake: multiplies by the size in float, before it takes the fraction
// credit: 85..97
// hint: Far from 0 a float has few bits behind the point, and u * n has fewer still: take the fraction of u first.
// Beside borders, the product rounds: use double.
#include <stdexcept>
#include <umbral/texturing/lookup.hpp>

namespace umbral::texturing {
namespace {

float usable(float coordinate, Wrap wrap)
{
    if (std::isnan(coordinate)) return 0;
    if (wrap == Wrap::clamp_to_edge) return std::clamp(coordinate, 0.0F, 1.0F);
    return std::isinf(coordinate) ? 0 : coordinate;
}

long wrapped(long index, long count, Wrap wrap)
{
    if (wrap == Wrap::clamp_to_edge) return std::clamp(index, 0L, count - 1);
    return (index % count + count) % count;
}

}

glm::vec4 lookup(const Grid<glm::vec4>& texture, const Sampler& sampler, glm::vec2 uv)
{
    if (texture.cells.empty()) throw std::invalid_argument("no texel");
    const float x = usable(uv.x, sampler.wrap_u) * static_cast<float>(texture.width);
    const float y = usable(uv.y, sampler.wrap_v) * static_cast<float>(texture.height);
    const auto texel = [&](float column, float row) {
        const long i = wrapped(static_cast<long>(column), texture.width, sampler.wrap_u);
        const long j = wrapped(static_cast<long>(row), texture.height, sampler.wrap_v);
        return texture.at(static_cast<int>(i), static_cast<int>(texture.height - 1 - j));
    };
    if (sampler.filter == Filter::nearest) return texel(std::floor(x), std::floor(y));

    const float left = std::floor(x - 0.5F);
    const float below = std::floor(y - 0.5F);
    const float s = x - 0.5F - left;
    const float t = y - 0.5F - below;
    const glm::vec4 lower = mix(texel(left, below), texel(left + 1, below), s);
    const glm::vec4 upper = mix(texel(left, below + 1), texel(left + 1, below + 1), s);
    return mix(lower, upper, t);
}

}
