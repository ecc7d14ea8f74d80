// alternative: places the branches by translation, rotation and scaling, of depths too; another triangulation, and
// edges one by one
#include <umbral/transforms/tree.hpp>

namespace umbral::transforms {

void draw_trunk(Pipeline& pipeline)
{
    const auto& p = trunk_polygon;
    const glm::vec3 before = pipeline.color();
    pipeline.set_color(trunk_fill);
    const std::vector<glm::vec2> corners{p[0], p[1], p[8], p[1], p[2], p[8], p[8], p[2], p[5], p[2], p[3],
                                         p[5], p[3], p[4], p[5], p[7], p[8], p[5], p[7], p[5], p[6]};
    pipeline.fill_triangles(corners);
    pipeline.set_color(trunk_edges);
    for (const std::size_t i : {8, 7, 5, 4, 2, 1}) {
        const glm::vec2 edge[] = {p[(i + 1) % 9], p[i]};
        pipeline.draw_polyline(edge);
    }
    pipeline.set_color(before);
}

void draw_tree(Pipeline& pipeline, unsigned levels, const Figure& trunk)
{
    if (levels < 1) return;
    const glm::dmat4 one(1);
    trunk(pipeline);
    pipeline.push();
    pipeline.compose(glm::mat4(glm::scale(glm::translate(one, {-0.5, 3.0, 0.0}), {0.5, 0.5, 0.5})));
    draw_tree(pipeline, levels - 1, trunk);
    pipeline.pop();
    pipeline.push();
    pipeline.compose(glm::mat4(glm::translate(one, {1.5, 2.5, 0.0})));
    pipeline.compose(glm::mat4(glm::rotate(one, glm::radians(-45.0), {0, 0, 1})));
    pipeline.compose(glm::mat4(glm::scale(one, glm::dvec3(std::sqrt(0.5), std::sqrt(0.5), 1))));
    draw_tree(pipeline, levels - 1, trunk);
    pipeline.pop();
}

}
