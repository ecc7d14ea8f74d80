#include <stdexcept>
#include <umbral/texturing/lookup.hpp>

namespace umbral::texturing {
namespace {

struct Tap {
    int texel;
    float weight;
};

std::array<Tap, 2> taps(float coordinate, int count, Wrap wrap, Filter filter)
{
    float inside = 0;
    if (wrap == Wrap::repeat && std::isfinite(coordinate))
        inside = std::fmin(coordinate - std::floor(coordinate), 0x1.fffffep-1F);
    if (wrap == Wrap::clamp_to_edge && coordinate > 0) inside = std::fmin(coordinate, 1.0F);
    const double place = static_cast<double>(inside) * count;
    const auto bounded = [&](int index) {
        if (index < 0) return wrap == Wrap::repeat ? count - 1 : 0;
        if (index >= count) return wrap == Wrap::repeat ? 0 : count - 1;
        return index;
    };
    if (filter == Filter::nearest) return {{{bounded(static_cast<int>(place)), 1}, {0, 0}}};
    const double first = std::floor(place - 0.5);
    const auto second_weight = static_cast<float>(place - 0.5 - first);
    return {
        {{bounded(static_cast<int>(first)), 1 - second_weight}, {bounded(static_cast<int>(first) + 1), second_weight}}};
}

}

glm::vec4 lookup(const Grid<glm::vec4>& texture, const Sampler& sampler, glm::vec2 uv)
{
    if (texture.cells.empty()) throw std::invalid_argument("no texel");
    glm::vec4 sum(0);
    for (const Tap& row : taps(uv.y, texture.height, sampler.wrap_v, sampler.filter))
        for (const Tap& column : taps(uv.x, texture.width, sampler.wrap_u, sampler.filter))
            sum += row.weight * column.weight * texture.at(column.texel, texture.height - 1 - row.texel);
    return sum;
}

}
