// Based on: ISO/IEC 9592-1. Programmer's Hierarchical Interactive Graphics System (PHIGS). 1989: a figure is a graph of
// parts, and its pose a few of the graph's matrices; each of those is computed from its parameter, never from its last
// value.

#include <cmath>
#include <numbers>
#include <umbral/transforms/android.hpp>

namespace umbral::transforms {
namespace {

using namespace android_measures;

const glm::dvec3 x_axis(1, 0, 0);
const glm::dvec3 y_axis(0, 1, 0);
const glm::dvec3 z_axis(0, 0, 1);

glm::mat4 move(const glm::vec3& by) { return glm::translate(glm::mat4(1), by); }
glm::mat4 scale(float x, float y, float z) { return glm::scale(glm::mat4(1), {x, y, z}); }
glm::mat4 turn(double angle, const glm::dvec3& axis) { return glm::mat4(glm::rotate(glm::dmat4(1), angle, axis)); }

/// The part at x > 0, and the one at x < 0: their places are mirrored.
constexpr float sides[] = {1, -1};
glm::vec3 on_side(float side, const glm::vec3& place) { return {side * place.x, place.y, place.z}; }

/// What `draw` composes ends with it.
template <class Draw>
void between_push_and_pop(Pipeline& pipeline, Draw draw)
{
    pipeline.push();
    draw();
    pipeline.pop();
}

/// `primitive`, placed by one matrix.
void draw_placed(Pipeline& pipeline, const glm::mat4& place, Primitive primitive)
{
    between_push_and_pop(pipeline, [&] {
        pipeline.compose(place);
        pipeline.draw(primitive);
    });
}

/// An arm or a leg, hanging from the origin: drawn four times.
void draw_limb(Pipeline& pipeline)
{
    const float r = limb_radius;
    draw_placed(pipeline, scale(r, r, r), Primitive::half_sphere);
    pipeline.compose(move({0, -limb_length, 0}));
    draw_placed(pipeline, scale(r, limb_length, r), Primitive::cylinder);
    draw_placed(pipeline, turn(std::numbers::pi, x_axis) * scale(r, r, r), Primitive::half_sphere);
}

void draw_head(Pipeline& pipeline)
{
    pipeline.draw(Primitive::half_sphere);
    const glm::vec3 color = pipeline.color();
    pipeline.set_color(glm::vec3(1));
    for (const float side : sides)
        draw_placed(
            pipeline,
            move(on_side(side, eye)) * turn(std::numbers::pi / 2, x_axis) * scale(eye_radius, eye_radius, eye_radius),
            Primitive::half_sphere);
    pipeline.set_color(color);
    for (const float side : sides)
        draw_placed(pipeline,
                    move(on_side(side, antenna)) * turn(-side * antenna_tilt, z_axis) *
                        scale(antenna_radius, antenna_length, antenna_radius),
                    Primitive::cylinder);
}

class ReferenceAndroid final : public Android {
public:
    void set_left_arm(double angle) override { set(left_arm_, angle); }
    void set_right_arm(double angle) override { set(right_arm_, angle); }
    void set_head(double angle) override { set(head_, angle); }

    void draw(Pipeline& pipeline) const override
    {
        draw_placed(pipeline, scale(1, body_height, 1), Primitive::cylinder);
        between_push_and_pop(pipeline, [&] {
            pipeline.compose(move({0, head_height, 0}));
            pipeline.compose(turn(head_, y_axis));
            draw_head(pipeline);
        });
        const double arms[] = {left_arm_, right_arm_};
        for (int i = 0; i < 2; ++i) draw_limb_at(pipeline, on_side(sides[i], shoulder), arms[i]);
        for (const float side : sides) draw_limb_at(pipeline, on_side(side, hip), 0);
    }

private:
    static void set(double& parameter, double angle)
    {
        if (std::isfinite(angle)) parameter = angle;
    }

    static void draw_limb_at(Pipeline& pipeline, const glm::vec3& place, double angle)
    {
        between_push_and_pop(pipeline, [&] {
            pipeline.compose(move(place));
            pipeline.compose(turn(angle, x_axis));
            draw_limb(pipeline);
        });
    }

    double left_arm_ = 0;
    double right_arm_ = 0;
    double head_ = 0;
};

}

std::unique_ptr<Android> make_android() { return std::make_unique<ReferenceAndroid>(); }

}
