#include <umbral/pipeline/software.hpp>

namespace umbral::pipeline {

void draw_triangles(const PipelineState& state, std::span<const ColoredVertex> vertices,
                    std::span<const glm::uvec3> triangles, Layer& target)
{
    // TODO: for each vertex: clip coordinates, by state.to_clip.
    // For each triangle:
    // 1. clip_triangle gives the corners of what is left; none: go on with the next one.
    // 2. Divide each corner by its w, bring it to the viewport (y goes down there), and keep 1/w and the corner's
    // weights.
    // 3. Is the polygon's front on the screen, and is that culled?
    // 4. Fragments, as state.mode says. Their weights must be those of the triangle's vertices, not of the polygon's
    // corners.
    // 5. Drop those outside the viewport, move the others to the picture, drop those outside the picture.
    // 6. draw_fragments tests and writes them.
    (void)not_implemented<int>(state, vertices.size(), triangles.size(), target);
}

}
