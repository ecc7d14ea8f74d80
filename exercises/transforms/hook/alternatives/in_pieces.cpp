// alternative: draws the hook in two pieces, places hooks by GLM's functions and by unit vectors, and the last one
// first
#include <numbers>
#include <umbral/transforms/hook.hpp>

namespace umbral::transforms {

void draw_hook(Pipeline& pipeline)
{
    pipeline.draw_polyline(std::vector<glm::vec2>{{0, 0}, {1, 0}, {1, 1}});
    pipeline.draw_polyline(std::vector<glm::vec2>{{1, 1}, {0, 1}, {0, 2}});
}

void draw_four_hooks(Pipeline& pipeline, const Figure& hook)
{
    const glm::mat4 next = glm::rotate(glm::translate(glm::mat4(1), {0, 2, 0}), glm::radians(90.0F), {0, 0, 1});
    for (int i = 0; i < 4; ++i) {
        hook(pipeline);
        pipeline.compose(next);
    }
}

void draw_hook_between(Pipeline& pipeline, const Figure& hook, const glm::vec3& from, const glm::vec3& to)
{
    const float angle = -std::atan2(to.x - from.x, to.y - from.y);
    const float size = 0.5F * std::hypot(to.x - from.x, to.y - from.y);
    pipeline.push();
    pipeline.compose(glm::translate(glm::mat4(1), {from.x, from.y, 0}));
    pipeline.compose(glm::rotate(glm::mat4(1), angle, {0, 0, 1}));
    pipeline.compose(glm::scale(glm::mat4(1), glm::vec3(size)));
    hook(pipeline);
    pipeline.pop();
}

glm::mat4 hook_matrix(const glm::vec3& from, const glm::vec3& to)
{
    const glm::dvec2 up = (glm::dvec2(to.x, to.y) - glm::dvec2(from.x, from.y)) * 0.5;
    glm::mat4 matrix(1);
    matrix[0] = glm::vec4(up.y, -up.x, 0, 0);
    matrix[1] = glm::vec4(up.x, up.y, 0, 0);
    matrix[3] = glm::vec4(from.x, from.y, 0, 1);
    return matrix;
}

void draw_hook_circle(Pipeline& pipeline, const Figure& hook, unsigned count)
{
    for (unsigned i = count; i-- > 0;) {
        const float step = 2 * std::numbers::pi_v<float> / static_cast<float>(count);
        const float begin = static_cast<float>(i) * step;
        const float end = static_cast<float>(i + 1) * step;
        draw_hook_between(pipeline, hook, {std::cos(begin), std::sin(begin), 1}, {std::cos(end), std::sin(end), 1});
    }
}

}
