#include <umbral/pipeline/depth.hpp>

namespace umbral::pipeline {

bool depth_passes(DepthFunction function, float incoming, float stored)
{
    // TODO: what each of the eight functions says about two depths.
    return not_implemented<bool>(function, incoming, stored);
}

float stored_depth(DepthFormat format, float depth)
{
    // TODO: clamp to [0, 1]; then the nearest k / 65535 or k / 16777215, or the depth itself.
    return not_implemented<float>(format, depth);
}

void test_depth(const DepthState& state, std::vector<Fragment>& fragments, Grid<float>& depths)
{
    // TODO: for each fragment in turn: round its depth as the buffer does, compare, and keep or remove the fragment. If
    // it passes, store the rounded depth, unless the state forbids it.
    (void)not_implemented<int>(state, fragments, depths);
}

void draw_fragments(const DepthState& state, ShadeModel model, const std::array<glm::vec3, 3>& colors,
                    const std::vector<Fragment>& fragments, Layer& target)
{
    // TODO: as test_depth; and write a colour where a fragment passes.
    (void)not_implemented<int>(state, model, colors, fragments, target);
}

void merge_layers(const DepthState& state, const Layer& source, Layer& target)
{
    // TODO: the same for each pixel of `source`.
    (void)not_implemented<int>(state, source, target);
}

}
