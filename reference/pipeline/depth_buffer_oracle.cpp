// The same interface in whole numbers: depths are compared by their codes, and codes come from the bits of the float.
// No fraction is ever rounded.

#include <cmath>
#include <stdexcept>
#include <umbral/pipeline/depth.hpp>

namespace umbral::pipeline {
namespace {

// The nearest integer to depth * last, half up. depth in (0, 1) is mantissa / 2^shift, with a mantissa of 24 bits.
std::uint64_t code_of(float depth, std::uint64_t last)
{
    if (!(depth > 0)) return 0;
    if (depth >= 1) return last;
    int exponent = 0;
    const float fraction = std::frexp(depth, &exponent);
    const auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, 24));
    const int shift = 24 - exponent;
    const std::uint64_t product = mantissa * last;
    if (shift > 60) return 0;
    return (product + (std::uint64_t{1} << (shift - 1))) >> shift;
}

}

bool depth_passes(DepthFunction function, float incoming, float stored)
{
    switch (function) {
        case DepthFunction::never: return false;
        case DepthFunction::less: return incoming < stored;
        case DepthFunction::equal: return incoming == stored;
        case DepthFunction::less_equal: return incoming <= stored;
        case DepthFunction::greater: return incoming > stored;
        case DepthFunction::not_equal: return incoming != stored;
        case DepthFunction::greater_equal: return incoming >= stored;
        case DepthFunction::always: break;
    }
    return true;
}

float stored_depth(DepthFormat format, float depth)
{
    if (format == DepthFormat::float32) return depth > 1 ? 1.0F : depth > 0 ? depth : 0.0F;
    const std::uint64_t last = format == DepthFormat::unorm16 ? 0xFFFF : 0xFFFFFF;
    return static_cast<float>(code_of(depth, last)) / static_cast<float>(last);
}

void test_depth(const DepthState& state, std::vector<Fragment>& fragments, Grid<float>& depths)
{
    std::vector<Fragment> passed;
    for (const Fragment& fragment : fragments) {
        float& stored = depths.at(fragment.pixel.x, fragment.pixel.y);
        const float incoming = stored_depth(state.format, fragment.depth);
        if (state.enabled && !depth_passes(state.function, incoming, stored)) continue;
        if (state.enabled && state.writes) stored = incoming;
        passed.push_back(fragment);
    }
    fragments = passed;
}

void draw_fragments(const DepthState& state, ShadeModel model, const std::array<glm::vec3, 3>& colors,
                    const std::vector<Fragment>& fragments, Layer& target)
{
    std::vector<Fragment> passed = fragments;
    test_depth(state, passed, target.depths);
    for (const auto& [pixel, depth, weights] : passed) {
        const glm::dvec3 blend = double{weights.x} * glm::dvec3(colors[0]) + double{weights.y} * glm::dvec3(colors[1]) +
                                 double{weights.z} * glm::dvec3(colors[2]);
        target.colors.at(pixel.x, pixel.y) = model == ShadeModel::flat ? colors[2] : glm::vec3(blend);
    }
}

void merge_layers(const DepthState& state, const Layer& source, Layer& target)
{
    if (source.colors.width != target.colors.width || source.colors.height != target.colors.height)
        throw std::invalid_argument("merge_layers: expected two layers of one size");
    std::vector<Fragment> all;
    for (int y = 0; y < source.depths.height; ++y)
        for (int x = 0; x < source.depths.width; ++x) all.push_back({{x, y}, source.depths.at(x, y), glm::vec3(0)});
    test_depth(state, all, target.depths);
    for (const Fragment& fragment : all)
        target.colors.at(fragment.pixel.x, fragment.pixel.y) = source.colors.at(fragment.pixel.x, fragment.pixel.y);
}

}
