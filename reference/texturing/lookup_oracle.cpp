#include <cmath>
#include <umbral/texturing/lookup.hpp>

// Places as whole texels and a rest: the fraction of a float has at most 24 bits, so that its product with the size is
// exact in double. The four weights are formed in double, and the sum is rounded to float once.

namespace umbral::texturing {
namespace {

// Texels from the left or lower border.
struct Place {
    long whole;
    double rest;  // in [0, 1)
};

long modulo(long index, long count) { return (index % count + count) % count; }

Place place(float coordinate, int count, Wrap wrap)
{
    if (std::isnan(coordinate) || (std::isinf(coordinate) && wrap == Wrap::repeat)) return {0, 0};
    if (wrap == Wrap::clamp_to_edge) coordinate = std::fmin(std::fmax(coordinate, 0.0F), 1.0F);
    // fmod is exact. A negative fraction of p texels is count - p, never rounded up to the border that it lies below.
    const double fraction = std::fmod(double{coordinate}, wrap == Wrap::repeat ? 1.0 : 2.0);
    const double product = std::fabs(fraction) * count;  // exact: 24 bits times at most 29
    const long whole = static_cast<long>(product);
    const double rest = product - static_cast<double>(whole);
    if (fraction >= 0) return {whole, rest};
    if (rest == 0) return {count - whole, 0};
    return {count - whole - 1, std::fmin(1 - rest, 1 - 0x1p-53)};
}

long wrapped(long index, long count, Wrap wrap)
{
    if (wrap == Wrap::repeat) return modulo(index, count);
    return index < 0 ? 0 : index >= count ? count - 1 : index;
}

// The two nearest centres along one axis and the weight of the second.
struct Neighbours {
    long first, second;
    double weight;
};

Neighbours neighbours(const Place& at, int count, Wrap wrap, Filter filter)
{
    if (filter == Filter::nearest) return {wrapped(at.whole, count, wrap), 0, 0};
    const bool second_half = at.rest >= 0.5;
    const long first = second_half ? at.whole : at.whole - 1;
    return {wrapped(first, count, wrap), wrapped(first + 1, count, wrap), second_half ? at.rest - 0.5 : at.rest + 0.5};
}

}

glm::vec4 lookup(const Grid<glm::vec4>& texture, const Sampler& sampler, glm::vec2 uv)
{
    const Neighbours across =
        neighbours(place(uv.x, texture.width, sampler.wrap_u), texture.width, sampler.wrap_u, sampler.filter);
    const Neighbours up =
        neighbours(place(uv.y, texture.height, sampler.wrap_v), texture.height, sampler.wrap_v, sampler.filter);
    glm::dvec4 sum(0);
    for (const auto& [column, share] : {std::pair{across.first, 1 - across.weight}, {across.second, across.weight}})
        for (const auto& [row, part] : {std::pair{up.first, 1 - up.weight}, {up.second, up.weight}})
            sum += share * part *
                   glm::dvec4(texture.at(static_cast<int>(column), texture.height - 1 - static_cast<int>(row)));
    return glm::vec4(sum);
}

}
