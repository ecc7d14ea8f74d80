// Based on: A. Lindenmayer. Mathematical Models for Cellular Interactions in Development. Journal of Theoretical
// Biology 18, 1968: a plant is a part that repeats itself; here by recursion over the matrix stack.

#include <umbral/transforms/tree.hpp>

namespace umbral::transforms {
namespace {

/// Takes (0,0) to `from` and (1,0) to `to`, by a similarity. The numbers of the trunk are short binary fractions:
/// nothing is rounded, at any level.
glm::mat4 base_on(glm::vec2 from, glm::vec2 to)
{
    const glm::vec2 x = to - from;
    return {{x.x, x.y, 0, 0}, {-x.y, x.x, 0, 0}, {0, 0, 1, 0}, {from.x, from.y, 0, 1}};
}

}

void draw_trunk(Pipeline& pipeline)
{
    constexpr std::size_t triangles[][3] = {{0, 1, 2}, {0, 2, 8}, {2, 5, 8}, {2, 3, 4},
                                            {2, 4, 5}, {5, 6, 8}, {6, 7, 8}};
    constexpr std::size_t chains[][3] = {{1, 2, 3}, {4, 5, 6}, {7, 8, 0}};
    const glm::vec3 color = pipeline.color();
    pipeline.set_color(trunk_fill);
    for (const auto& [a, b, c] : triangles)
        pipeline.fill_triangles(std::array{trunk_polygon[a], trunk_polygon[b], trunk_polygon[c]});
    pipeline.set_color(trunk_edges);
    for (const auto& [a, b, c] : chains)
        pipeline.draw_polyline(std::array{trunk_polygon[a], trunk_polygon[b], trunk_polygon[c]});
    pipeline.set_color(color);
}

void draw_tree(Pipeline& pipeline, unsigned levels, const Figure& trunk)
{
    if (levels == 0) return;
    trunk(pipeline);
    for (const auto& [from, to] : {std::pair{7, 6}, {4, 3}}) {
        pipeline.push();
        pipeline.compose(
            base_on(trunk_polygon[static_cast<std::size_t>(from)], trunk_polygon[static_cast<std::size_t>(to)]));
        draw_tree(pipeline, levels - 1, trunk);
        pipeline.pop();
    }
}

}
