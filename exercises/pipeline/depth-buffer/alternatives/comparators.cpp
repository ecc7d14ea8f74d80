// alternative: function objects of the standard library, and codes by rounding in long double

#include <stdexcept>
#include <umbral/pipeline/depth.hpp>

namespace umbral::pipeline {

bool depth_passes(DepthFunction function, float incoming, float stored)
{
    switch (function) {
        case DepthFunction::never: return false;
        case DepthFunction::less: return std::less<>()(incoming, stored);
        case DepthFunction::equal: return std::equal_to<>()(incoming, stored);
        case DepthFunction::less_equal: return std::less_equal<>()(incoming, stored);
        case DepthFunction::greater: return std::greater<>()(incoming, stored);
        case DepthFunction::not_equal: return std::not_equal_to<>()(incoming, stored);
        case DepthFunction::greater_equal: return std::greater_equal<>()(incoming, stored);
        case DepthFunction::always: return true;
    }
    return true;
}

float stored_depth(DepthFormat format, float depth)
{
    if (depth <= 0) return 0;
    if (depth >= 1) return 1;
    if (format == DepthFormat::float32) return depth;
    const long double last = format == DepthFormat::unorm16 ? (1 << 16) - 1 : (1 << 24) - 1;
    return static_cast<float>(std::round(last * static_cast<long double>(depth)) / last);
}

void test_depth(const DepthState& state, std::vector<Fragment>& fragments, Grid<float>& depths)
{
    const auto fails = [&](const Fragment& fragment) {
        float& stored = depths.at(fragment.pixel.x, fragment.pixel.y);
        const float incoming = stored_depth(state.format, fragment.depth);
        const bool passes = depth_passes(state.function, incoming, stored);
        if (passes && state.writes) stored = incoming;
        return !passes;
    };
    std::vector<Fragment> left;
    if (!state.enabled) return;
    for (const Fragment& fragment : fragments)
        if (!fails(fragment)) left.push_back(fragment);
    fragments.swap(left);
}

void draw_fragments(const DepthState& state, ShadeModel model, const std::array<glm::vec3, 3>& colors,
                    const std::vector<Fragment>& fragments, Layer& target)
{
    std::vector<Fragment> left = fragments;
    test_depth(state, left, target.depths);
    for (const Fragment& fragment : left) {
        glm::vec3 color(0);
        for (int i = 0; i < 3; ++i) color += fragment.weights[i] * colors[static_cast<std::size_t>(i)];
        target.colors.at(fragment.pixel.x, fragment.pixel.y) = model == ShadeModel::smooth ? color : colors.back();
    }
}

void merge_layers(const DepthState& state, const Layer& source, Layer& target)
{
    if (source.colors.width != target.colors.width || source.colors.height != target.colors.height)
        throw std::invalid_argument("layers of different sizes");
    for (int y = 0; y < source.colors.height; ++y)
        for (int x = 0; x < source.colors.width; ++x) {
            const glm::vec3 color = source.colors.at(x, y);
            draw_fragments(state, ShadeModel::flat, {color, color, color},
                           {{{x, y}, source.depths.at(x, y), {1, 0, 0}}}, target);
        }
}

}
