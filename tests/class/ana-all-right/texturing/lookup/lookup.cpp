#include <stdexcept>
#include <umbral/texturing/lookup.hpp>

namespace umbral::texturing {
namespace {

double usable(float coordinate, Wrap wrap)
{
    if (std::isnan(coordinate)) return 0;
    if (wrap == Wrap::clamp_to_edge) return std::clamp<double>(coordinate, 0, 1);
    // Whole turns would not fit into whole numbers; the remainder is exact.
    return std::isinf(coordinate) ? 0 : std::fmod(double{coordinate}, 1.0);
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
    const double x = usable(uv.x, sampler.wrap_u) * texture.width;
    const double y = usable(uv.y, sampler.wrap_v) * texture.height;
    const auto texel = [&](double column, double row) {
        const long i = wrapped(static_cast<long>(column), texture.width, sampler.wrap_u);
        const long j = wrapped(static_cast<long>(row), texture.height, sampler.wrap_v);
        return glm::dvec4(texture.at(static_cast<int>(i), static_cast<int>(texture.height - 1 - j)));
    };
    if (sampler.filter == Filter::nearest) return glm::vec4(texel(std::floor(x), std::floor(y)));

    const double left = std::floor(x - 0.5);
    const double below = std::floor(y - 0.5);
    const double s = x - 0.5 - left;
    const double t = y - 0.5 - below;
    const glm::dvec4 lower = mix(texel(left, below), texel(left + 1, below), s);
    const glm::dvec4 upper = mix(texel(left, below + 1), texel(left + 1, below + 1), s);
    return glm::vec4(mix(lower, upper, t));
}

}
