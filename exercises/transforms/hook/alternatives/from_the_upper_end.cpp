// alternative: draws the hook from its upper end, segment by segment, and turns in two steps
#include <numbers>
#include <umbral/transforms/hook.hpp>

namespace umbral::transforms {

void draw_hook(Pipeline& pipeline)
{
    const std::vector<glm::vec2> places{{0, 2}, {0, 1}, {1, 1}, {1, 0}, {0, 0}};
    pipeline.push();
    for (std::size_t i = 1; i < places.size(); ++i)
        pipeline.draw_polyline(std::vector<glm::vec2>{places[i - 1], places[i]});
    pipeline.pop();
}

void draw_four_hooks(Pipeline& pipeline, const Figure& hook)
{
    for (int i = 0; i < 4; ++i) {
        hook(pipeline);
        pipeline.compose(glm::translate(glm::mat4(1), {0, 2, 0}));
        pipeline.compose(glm::rotate(glm::mat4(1), glm::radians(90.0F), {0, 0, 1}));
    }
}

void draw_hook_between(Pipeline& pipeline, const Figure& hook, const glm::vec3& from, const glm::vec3& to)
{
    const double angle = std::atan2(double{to.y} - from.y, double{to.x} - from.x);
    const double size = std::hypot(double{to.x} - from.x, double{to.y} - from.y) / 2;
    pipeline.push();
    pipeline.compose(glm::translate(glm::mat4(1), {from.x, from.y, 0}));
    pipeline.compose(glm::mat4(glm::scale(glm::dmat4(1), {size, size, 1})));
    pipeline.compose(glm::mat4(glm::rotate(glm::dmat4(1), angle, {0, 0, 1})));
    pipeline.compose(glm::mat4(glm::rotate(glm::dmat4(1), -std::numbers::pi / 2, {0, 0, 1})));
    hook(pipeline);
    pipeline.pop();
}

glm::mat4 hook_matrix(const glm::vec3& from, const glm::vec3& to)
{
    const float x = 0.5F * to.x - 0.5F * from.x;
    const float y = 0.5F * to.y - 0.5F * from.y;
    glm::mat4 matrix(1);
    matrix[0] = glm::vec4(y, -x, 0, 0);
    matrix[1] = glm::vec4(x, y, 0, 0);
    matrix[3] = glm::vec4(from.x, from.y, 0, 1);
    return matrix;
}

void draw_hook_circle(Pipeline& pipeline, const Figure& hook, unsigned count)
{
    if (count == 0) return;
    const auto place = [count](unsigned i) {
        const double angle = 2 * std::numbers::pi * i / count;
        return glm::vec3(std::cos(angle), std::sin(angle), 1);
    };
    for (unsigned i = 0; i < count; ++i) draw_hook_between(pipeline, hook, place(i), place(i + 1));
}

}
