#include <cmath>
#include <kit/scene.hpp>
#include <limits>
#include <umbral/projections/view.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>
#include <vector>

#include "../support.hpp"

namespace umbral {
namespace {

using namespace projections;

void record(Recorder& out, const std::vector<Placement>& cameras)
{
    for (const auto& [eye, target, up] : cameras) out.append("view", ask<view_matrix>(out, eye, target, up));
}

// Cameras whose matrices a student can work out by hand; the last three are those of problems 3.1 and 4.1.
std::vector<Placement> known()
{
    return {{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}},          {{0, 0, -5}, {0, 0, 0}, {0, 1, 0}},
            {{3, 0, 0}, {0, 0, 0}, {0, 1, 0}},          {{0, 4, 0}, {0, 0, 0}, {0, 0, -1}},
            {{1, 2, 3}, {1, 2, -5}, {1, 0, 0}},         {{0, 3, 4}, {0, 0, 0}, {0, 1, 0}},
            {{5, 1, -2}, {2, 1, 2}, {0, 1, 0}},         {{2.1213203F, 0.5F, 2.1213203F}, {0, 0.5F, 0}, {0, 1, 0}},
            {{2.5F, 1, 2.5F}, {0, 0.5F, 0}, {0, 1, 0}}, {{5, 1, 0}, {0, 1, 0}, {0, 1, 0}}};
}

/// The same cameras in worlds that are turned by quarters, if inputs are to vary: what is exact remains exact.
std::vector<Placement> turned(Variation& vary, std::vector<Placement> cameras)
{
    for (auto& [eye, target, up] : cameras) {
        const ExactMap map = vary.exact_map();
        eye = map.place(eye);
        target = map.place(target);
        up = map.direction(up);
    }
    return cameras;
}

std::vector<Placement> random_cameras(Random& random, int count)
{
    std::vector<Placement> cameras;
    for (int i = 0; i < count; ++i) cameras.push_back(random_placement(random));
    return cameras;
}

// Every second pair in a world that is as much as 2^60 times as small, or a thousand times as large.
std::vector<Placement> in_worlds_of_any_size(std::vector<Placement> cameras, Random& random)
{
    float size = 1;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        if (i % 4 == 0) size = std::ldexp(1.0F, static_cast<int>(random.below(71)) - 60);
        if (i % 4 == 2) size = 1;
        cameras[i].eye *= size;
        cameras[i].target *= size;
    }
    return cameras;
}

// Each of them, and the same with another up, target or eye: whoever remembers what was asked before has to look at all
// three.
std::vector<Placement> with_one_thing_changed(const std::vector<Placement>& cameras, Random& random)
{
    std::vector<Placement> all;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        all.push_back(cameras[i]);
        const Placement other = random_placement(random);
        Placement changed = cameras[i];
        if (i % 3 == 0) changed.up = other.up;
        if (i % 3 == 1) changed.target = other.target;
        if (i % 3 == 2) changed.eye = other.eye;
        // The other up is well off its own view.
        if (sine_to_up(changed) < 0.17) changed = other;
        all.push_back(changed);
    }
    return all;
}

// Only the direction of `up` counts.
std::vector<Placement> long_and_short_up(Random& random)
{
    std::vector<Placement> cameras = random_cameras(random, 200);
    for (Placement& camera : cameras) camera.up *= std::pow(10.0F, random.uniform(-15, 15));
    return cameras;
}

// A million units from the world's origin, and looking at it, or at a thing beside the camera.
std::vector<Placement> far_eyes(Random& random)
{
    std::vector<Placement> cameras;
    while (cameras.size() < 200) {
        Placement camera = random_placement(random);
        const glm::vec3 beside = camera.target - camera.eye;
        camera.eye = 1e6F * random.unit_vector();
        if (cameras.size() % 2 == 1) camera.target = camera.eye + beside;
        if (camera.target != camera.eye && sine_to_up(camera) >= 0.17) cameras.push_back(camera);
    }
    return cameras;
}

// Angles down to the threshold of 1e-6 and beyond it, where a world axis takes the place of `up`; of long and short
// ones, multiplied by powers of two, which change no direction.
std::vector<Placement> almost_parallel(Random& random)
{
    std::vector<Placement> cameras;
    for (const double sine : {1e-2, 1e-3, 1e-4, 1e-5, 1.25e-6, 8e-7}) {
        for (int count = 0; count < 40;) {
            const Placement camera = random_placement(random);
            if (!has_clear_smallest(camera.eye - camera.target)) continue;
            cameras.push_back(with_up_near_view(camera, sine, count % 2 == 1, random));
            cameras.back().up *= std::ldexp(1.0F, static_cast<int>(random.below(61)) - 30);
            ++count;
        }
        // Where eye and target are equal, the view is the world's -z.
        for (int count = 0; count < 6; ++count) {
            Placement camera = with_up_near_view({{0, 0, 1}, {0, 0, 0}, {}}, sine, count % 2 == 1, random);
            camera.eye = camera.target = 10.0F * random.in_cube();
            cameras.push_back(camera);
        }
    }
    return cameras;
}

// A vector of multiples of 1/64: differences of these, and their multiples by powers of two, are exact.
glm::vec3 on_grid(const glm::vec3& v) { return round(64.0F * v) / 64.0F; }

// The vector, which is along an axis, or in three of four cases turned by less than 1e-6.
glm::vec3 not_quite(glm::vec3 v, Random& random)
{
    const float size = length(v);
    const std::uint32_t which = random.below(4);
    for (int i = 0, other = 1; i < 3; ++i) {
        if (v[i] != 0) continue;
        const float off = size * std::pow(10.0F, random.uniform(-9, -6.3F));
        if (which == 0 || which == static_cast<std::uint32_t>(other++)) continue;
        v[i] = random.below(2) == 0 ? off : -off;
    }
    return v;
}

// A view of which two components are equal, or differ by some units of their last digit, and the third one is larger.
Placement with_nearly_equal_components(Random& random)
{
    const float size = static_cast<float>(20 + random.below(300)) / 64;
    const float second = size * (1 + std::ldexp(static_cast<float>(random.below(5)) - 2, -21));
    const float third = size + static_cast<float>(random.below(200)) / 64;
    const auto first_axis = static_cast<int>(random.below(3));
    const bool turns = random.below(2) == 0;
    glm::vec3 eye(third);
    eye[first_axis] = size;
    eye[(first_axis + (turns ? 1 : 2)) % 3] = second;
    for (int i = 0; i < 3; ++i) eye[i] *= random.below(2) == 0 ? 1.0F : -1.0F;
    return {eye, {0, 0, 0}, {0, 0, 0}};
}

// Some floats further or less far.
float next_to(float value, int steps)
{
    for (; steps > 0; --steps) value = std::nextafter(value, 2 * value);
    for (; steps < 0; ++steps) value = std::nextafter(value, 0.0F);
    return value;
}

// One to three steps of these lengths from zero, or none, in each coordinate.
glm::ivec3 few_steps(Random& random)
{
    glm::ivec3 steps(0);
    for (int i = 0; i < 3; ++i) steps[i] = static_cast<int>(random.below(7)) - 3;
    return steps;
}

// Only equal is equal, and only null is null: lengths of which the squares are no floats, in worlds of any size.
std::vector<Placement> any_size(Random& random)
{
    std::vector<Placement> cameras;
    while (cameras.size() < 120) {
        Placement camera = random_placement(random);
        const std::size_t kind = cameras.size() % 6;
        if (kind < 2) {
            const auto doublings = static_cast<int>(random.below(80));
            const float size = std::ldexp(1.0F, kind == 0 ? -60 - doublings : 36 + doublings);
            camera.eye = size * on_grid(camera.eye);
            camera.target = size * on_grid(camera.target);
        }
        if (kind == 2) camera.up *= std::pow(10.0F, random.uniform(-42, 37.5F));
        if (kind == 3) {
            camera.eye *= std::pow(10.0F, random.uniform(-3, 5));
            const glm::ivec3 steps = few_steps(random);
            for (int i = 0; i < 3; ++i) camera.target[i] = next_to(camera.eye[i], steps[i]);
        }
        if (kind == 4) {
            camera.eye = glm::vec3(0);
            camera.target = std::numeric_limits<float>::denorm_min() * glm::vec3(few_steps(random));
            if (random.below(2) == 0) std::swap(camera.eye, camera.target);
        }
        if (kind == 5) {
            const float size = random.uniform(1, 2);
            const auto axis = static_cast<int>(random.below(3));
            camera = {glm::vec3(4), glm::vec3(0), glm::vec3(0)};
            camera.eye[axis] = size;
            camera.eye[(axis + 1) % 3] = next_to(size, static_cast<int>(random.below(3)) - 1);
        } else if (camera.eye == camera.target || sine_to_up(camera) < 0.17) {
            continue;
        }
        cameras.push_back(camera);
    }
    return cameras;
}

// Where the textbook divides by zero, and what is close to it. The rules are those of the interface's comment.
std::vector<Placement> degenerate(Random& random)
{
    std::vector<Placement> cameras = {
        {{0, 10, 0}, {0, 0, 0}, {0, 1, 0}}, {{0, 10, 0}, {0, 0, 0}, {0, -3, 0}}, {{2, -5, 1}, {2, 4, 1}, {0, 1, 0}},
        {{7, 0, 0}, {0, 0, 0}, {1, 0, 0}},  {{0, 0, 5}, {0, 0, 0}, {0, 0, 1}},   {{1, 2, 3}, {1, 2, 3}, {0, 1, 0}},
        {{1, 2, 3}, {1, 2, 3}, {0, 0, 2}},  {{-4, 5, 6}, {-4, 5, 6}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}, {1, 1, 0}}};
    while (cameras.size() < 109) {
        Placement camera = random_placement(random);
        camera.eye = on_grid(camera.eye);
        camera.target = on_grid(camera.target);
        // Every second view is along an axis: the two others are perpendicular to it.
        const bool along_axis = cameras.size() / 4 % 2 == 0;
        if (along_axis) {
            const auto axis = static_cast<int>(random.below(3));
            camera.target = camera.eye;
            camera.target[axis] += (random.below(2) == 0 ? 0.125F : -0.125F) * static_cast<float>(1 + random.below(80));
        }
        const bool up_is_null = cameras.size() % 4 == 1;
        if (up_is_null && !along_axis) camera = with_nearly_equal_components(random);
        const glm::vec3 view = camera.eye - camera.target;
        if (!up_is_null && !along_axis && !has_clear_smallest(view)) continue;
        switch (cameras.size() % 4) {
            case 0:
                camera.up =
                    std::ldexp(random.below(2) == 0 ? 1.0F : -1.0F, static_cast<int>(random.below(9)) - 4) * view;
                if (along_axis) camera.up = not_quite(camera.up, random);
                break;
            case 1: camera.up = glm::vec3(0); break;
            case 2: {
                // Not degenerate: eye and target are only near to each other.
                if (sine_to_up(camera) < 0.17) continue;
                const float size = std::ldexp(1.0F, -30 - static_cast<int>(random.below(30)));
                camera.eye *= size;
                camera.target *= size;
                break;
            }
            default:
                camera.target = camera.eye;
                if (length(glm::vec2(camera.up)) < 0.2F) continue;
        }
        cameras.push_back(camera);
    }
    return cameras;
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record(out, turned(c.vary, known())); }},
    {"random",
     [](Case& c, Recorder& out) {
         const std::vector<Placement> cameras = with_one_thing_changed(random_cameras(c.random, 250), c.random);
         record(out, in_worlds_of_any_size(cameras, c.random));
     }},
    {"long and short up", [](Case& c, Recorder& out) { record(out, long_and_short_up(c.random)); }},
    {"far eye", [](Case& c, Recorder& out) { record(out, far_eyes(c.random)); }},
    {"almost parallel up", [](Case& c, Recorder& out) { record(out, almost_parallel(c.random)); }},
    {"any size", [](Case& c, Recorder& out) { record(out, any_size(c.random)); }},
    {"degenerate", [](Case& c, Recorder& out) { record(out, degenerate(c.random)); }},
    {"picture",
     [](Case& c, Recorder& out) {
         const glm::mat4 view = ask<view_matrix>(out, c.vary.near(glm::vec3(3.4F, 2.5F, 4.4F), 0.8F),
                                                 glm::vec3(0.25F, 0.45F, 0), c.vary.near(glm::vec3(0.12F, 1, 0), 0.2F));
         out.image("colours", draw_scene(view));
     }},
};

}
