// Based on: E. Catmull. A Subdivision Algorithm for Computer Display of Curved Surfaces. 1974. Functions, mask and
// formats are those of OpenGL.

#include <algorithm>
#include <stdexcept>
#include <string>
#include <umbral/pipeline/depth.hpp>

namespace umbral::pipeline {
namespace {

// The cell of a pixel. Callers promise that it lies in the grid.
template <class Cell>
Cell& cell(Grid<Cell>& grid, const glm::ivec2& pixel)
{
    return grid.cells[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(grid.width) +
                      static_cast<std::size_t>(pixel.x)];
}

// Whether a depth passes against a stored one, which it replaces if the state allows it.
bool test(const DepthState& state, float depth, float& stored)
{
    if (!state.enabled) return true;
    const float incoming = stored_depth(state.format, depth);
    if (!depth_passes(state.function, incoming, stored)) return false;
    if (state.writes) stored = incoming;
    return true;
}

}

// The eight functions are the eight subsets of {less, equal, greater}; their order is that of the binary numbers.
bool depth_passes(DepthFunction function, float incoming, float stored)
{
    static_assert(static_cast<unsigned>(DepthFunction::less) == 1 && static_cast<unsigned>(DepthFunction::equal) == 2 &&
                  static_cast<unsigned>(DepthFunction::greater) == 4 &&
                  static_cast<unsigned>(DepthFunction::always) == 7);
    const unsigned relation = incoming < stored ? 1 : incoming == stored ? 2 : 4;
    return (static_cast<unsigned>(function) & relation) != 0;
}

float stored_depth(DepthFormat format, float depth)
{
    const float clamped = std::clamp(depth, 0.0F, 1.0F);
    if (format == DepthFormat::float32) return clamped;
    const float last = format == DepthFormat::unorm16 ? 0xFFFF : 0xFFFFFF;
    // A product of two 24-bit numbers is exact in double, and so is the sum: the code is never one off.
    const auto code = static_cast<std::int32_t>(double{clamped} * double{last} + 0.5);
    return static_cast<float>(code) / last;
}

void test_depth(const DepthState& state, std::vector<Fragment>& fragments, Grid<float>& depths)
{
    if (!state.enabled) return;
    auto kept = fragments.begin();
    for (const Fragment& fragment : fragments)
        if (test(state, fragment.depth, cell(depths, fragment.pixel))) *kept++ = fragment;
    fragments.erase(kept, fragments.end());
}

void draw_fragments(const DepthState& state, ShadeModel model, const std::array<glm::vec3, 3>& colors,
                    const std::vector<Fragment>& fragments, Layer& target)
{
    const glm::mat3 corners(colors[0], colors[1], colors[2]);
    for (const Fragment& fragment : fragments)
        if (test(state, fragment.depth, cell(target.depths, fragment.pixel)))
            cell(target.colors, fragment.pixel) = model == ShadeModel::flat ? colors[2] : corners * fragment.weights;
}

void merge_layers(const DepthState& state, const Layer& source, Layer& target)
{
    const std::size_t pixels = target.colors.cells.size();
    if (source.colors.width != target.colors.width || source.colors.height != target.colors.height ||
        source.depths.cells.size() != pixels || target.depths.cells.size() != pixels)
        throw std::invalid_argument("merge_layers: expected two layers of one size, got " +
                                    std::to_string(source.colors.width) + " x " + std::to_string(source.colors.height) +
                                    " and " + std::to_string(target.colors.width) + " x " +
                                    std::to_string(target.colors.height));
    for (std::size_t i = 0; i < pixels; ++i)
        if (test(state, source.depths.cells[i], target.depths.cells[i]))
            target.colors.cells[i] = source.colors.cells[i];
}

}
