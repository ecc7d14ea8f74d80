// Based on: the course's class of problems on modelview matrices (2.15 to 2.18); a similarity of the plane is a product
// of complex numbers (C. Wessel. Om Directionens analytiske Betegning. 1799), so that nothing needs an angle.

#include <cmath>
#include <numbers>
#include <umbral/transforms/hook.hpp>

namespace umbral::transforms {
namespace {

constexpr float hook_height = 2;
const glm::vec3 z_axis(0, 0, 1);

glm::mat4 translation(const glm::vec2& by) { return glm::translate(glm::mat4(1), glm::vec3(by, 0)); }

}

void draw_hook(Pipeline& pipeline)
{
    constexpr glm::vec2 places[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 2}};
    pipeline.draw_polyline(places);
}

void draw_four_hooks(Pipeline& pipeline, const Figure& hook)
{
    // A quarter turn from its whole numbers: four of them are the identity exactly.
    const glm::mat4 quarter_turn({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});
    for (int i = 0; i < 4; ++i) {
        hook(pipeline);
        pipeline.compose(translation({0, hook_height}));
        pipeline.compose(quarter_turn);
    }
}

void draw_hook_between(Pipeline& pipeline, const Figure& hook, const glm::vec3& from, const glm::vec3& to)
{
    const glm::dvec2 along = glm::dvec2(to) - glm::dvec2(from);
    // The hook points along y, which is 90 degrees from x.
    const double angle = std::atan2(along.y, along.x) - std::numbers::pi / 2;
    const auto size = static_cast<float>(length(along) / hook_height);
    pipeline.push();
    pipeline.compose(translation(glm::vec2(from)));
    pipeline.compose(glm::mat4(glm::rotate(glm::dmat4(1), angle, glm::dvec3(z_axis))));
    pipeline.compose(glm::scale(glm::mat4(1), {size, size, 1}));
    hook(pipeline);
    pipeline.pop();
}

glm::mat4 hook_matrix(const glm::vec3& from, const glm::vec3& to)
{
    // y goes to half of the way from end to end; x to that, turned clockwise by 90 degrees.
    const glm::vec2 y = (glm::vec2(to) - glm::vec2(from)) / hook_height;
    return {{y.y, -y.x, 0, 0}, {y.x, y.y, 0, 0}, {0, 0, 1, 0}, {from.x, from.y, 0, 1}};
}

void draw_hook_circle(Pipeline& pipeline, const Figure& hook, unsigned count)
{
    const auto place = [&](unsigned i) {
        const double angle = 2 * std::numbers::pi * (i % count) / count;
        return glm::vec3(std::cos(angle), std::sin(angle), 1);
    };
    for (unsigned i = 0; i < count; ++i) {
        pipeline.push();
        pipeline.compose(hook_matrix(place(i), place(i + 1)));
        hook(pipeline);
        pipeline.pop();
    }
}

}
