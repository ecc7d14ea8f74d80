// Based on: L. Williams. Pyramidal Parametrics. SIGGRAPH 1983 (bilinear filtering); The OpenGL Graphics System,
// version 4.5, section 8.14.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <umbral/texturing/lookup.hpp>

namespace umbral::texturing {
namespace {

// The coordinate in [0, 1] that reads the same texels. With repeat the fraction is below 1 even where rounding (of
// -1e-30, say) would reach it.
double folded(double coordinate, Wrap wrap)
{
    if (wrap == Wrap::clamp_to_edge) return coordinate > 0 ? std::min(coordinate, 1.0) : 0;
    const double fraction = coordinate - std::floor(coordinate);
    return fraction >= 0 ? std::min(fraction, 1 - 0x1p-53) : 0;  // 0 also for NaN
}

// The texel that stands for number `index` of a row or column of `count`, where `index` is at most one step outside.
int wrapped(int index, int count, Wrap wrap)
{
    return wrap == Wrap::repeat ? (index + count) % count : std::clamp(index, 0, count - 1);
}

}

glm::vec4 lookup(const Grid<glm::vec4>& texture, const Sampler& sampler, glm::vec2 uv)
{
    if (texture.cells.empty())
        throw std::invalid_argument("lookup: expected a texture of at least one texel, got " +
                                    std::to_string(texture.width) + " x " + std::to_string(texture.height));
    // v counts from the bottom, rows from the top.
    const auto texel = [&](int column, int row_from_below) -> const glm::vec4& {
        return texture.at(wrapped(column, texture.width, sampler.wrap_u),
                          texture.height - 1 - wrapped(row_from_below, texture.height, sampler.wrap_v));
    };
    // In double the products of a float and a size are exact, and so is the decision which texels they fall between.
    const double x = folded(uv.x, sampler.wrap_u) * texture.width;
    const double y = folded(uv.y, sampler.wrap_v) * texture.height;
    if (sampler.filter == Filter::nearest) return texel(static_cast<int>(x), static_cast<int>(y));

    // Colours belong to the centres, half a texel from the borders.
    const int left = static_cast<int>(std::floor(x - 0.5));
    const int below = static_cast<int>(std::floor(y - 0.5));
    const auto to_right = static_cast<float>(x - 0.5 - left);
    const auto upwards = static_cast<float>(y - 0.5 - below);
    return mix(mix(texel(left, below), texel(left + 1, below), to_right),  //
               mix(texel(left, below + 1), texel(left + 1, below + 1), to_right), upwards);
}

}
