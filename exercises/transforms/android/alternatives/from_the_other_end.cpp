// alternative: cylinders drawn from their other end, turned or mirrored
#include <umbral/transforms/android.hpp>

namespace umbral::transforms {
namespace {

using namespace android_measures;

class DownwardAndroid : public Android {
public:
    void set_left_arm(double angle) override { keep(angle, angles_[0]); }
    void set_right_arm(double angle) override { keep(angle, angles_[1]); }
    void set_head(double angle) override { keep(angle, angles_[2]); }

    void draw(Pipeline& pipeline) const override
    {
        const glm::mat4 one(1);
        part(pipeline, glm::scale(glm::translate(one, {0, body_height, 0}), {1, -body_height, 1}), Primitive::cylinder);
        const glm::mat4 head = glm::rotate(glm::translate(one, {0, head_height, 0}), angles_[2], {0, 1, 0});
        part(pipeline, head, Primitive::half_sphere);
        const glm::vec3 before = pipeline.color();
        pipeline.set_color({1, 1, 1});
        for (int side = 1; side >= -1; side -= 2) {
            const glm::mat4 there = glm::translate(head, {static_cast<float>(side) * eye.x, eye.y, eye.z});
            part(pipeline, glm::scale(glm::rotate(there, glm::radians(90.0F), {1, 0, 0}), glm::vec3(eye_radius)),
                 Primitive::half_sphere);
        }
        pipeline.set_color(before);
        for (int side = 1; side >= -1; side -= 2) {
            const auto s = static_cast<float>(side);
            const glm::mat4 there = glm::translate(head, {s * antenna.x, antenna.y, antenna.z});
            part(pipeline,
                 glm::scale(glm::translate(glm::rotate(there, s * antenna_tilt, {0, 0, -1}), {0, antenna_length, 0}),
                            {antenna_radius, -antenna_length, antenna_radius}),
                 Primitive::cylinder);
        }
        limb(pipeline, glm::rotate(glm::translate(one, shoulder), angles_[0], {1, 0, 0}));
        limb(pipeline, glm::rotate(glm::translate(one, shoulder * glm::vec3(-1, 1, 1)), angles_[1], {1, 0, 0}));
        limb(pipeline, glm::translate(one, hip));
        limb(pipeline, glm::translate(one, -hip));
    }

private:
    static void keep(double angle, float& kept)
    {
        if (std::isfinite(angle)) kept = static_cast<float>(std::remainder(angle, 2 * glm::radians(180.0)));
    }
    static void part(Pipeline& pipeline, const glm::mat4& place, Primitive primitive)
    {
        pipeline.push();
        pipeline.compose(place);
        pipeline.draw(primitive);
        pipeline.pop();
    }
    static void limb(Pipeline& pipeline, const glm::mat4& place)
    {
        const float r = limb_radius;
        const glm::mat4 low = glm::translate(place, {0, -limb_length, 0});
        part(pipeline, glm::scale(place, glm::vec3(r)), Primitive::half_sphere);
        part(pipeline, glm::scale(glm::rotate(place, glm::radians(180.0F), {1, 0, 0}), {r, limb_length, r}),
             Primitive::cylinder);
        part(pipeline, glm::scale(low, {r, -r, r}), Primitive::half_sphere);
    }

    float angles_[3] = {};
};

}

std::unique_ptr<Android> make_android() { return std::make_unique<DownwardAndroid>(); }

}
