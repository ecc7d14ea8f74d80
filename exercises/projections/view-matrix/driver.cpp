#include <kit/scene.hpp>
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

// Every fourth in a world that is as much as 2^60 times as small, or a thousand times as large.
std::vector<Placement> in_worlds_of_any_size(std::vector<Placement> cameras, Random& random)
{
    for (std::size_t i = 0; i < cameras.size(); i += 4) {
        const float size = std::ldexp(1.0F, static_cast<int>(random.below(71)) - 60);
        cameras[i].eye *= size;
        cameras[i].target *= size;
    }
    return cameras;
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
    for (const double sine : {1e-2, 1e-3, 1e-4, 1e-5, 2e-6, 2e-7}) {
        for (int count = 0; count < 40;) {
            const Placement camera = random_placement(random);
            if (!has_clear_smallest(camera.eye - camera.target)) continue;
            cameras.push_back(with_up_near_view(camera, sine, count % 2 == 1, random));
            cameras.back().up *= std::ldexp(1.0F, static_cast<int>(random.below(61)) - 30);
            ++count;
        }
    }
    return cameras;
}

// A vector of multiples of 1/64: differences of these, and their multiples by powers of two, are exact.
glm::vec3 on_grid(const glm::vec3& v) { return round(64.0F * v) / 64.0F; }

// Where the textbook divides by zero. The rules are those of the interface's comment.
std::vector<Placement> degenerate(Random& random)
{
    std::vector<Placement> cameras = {
        {{0, 10, 0}, {0, 0, 0}, {0, 1, 0}}, {{0, 10, 0}, {0, 0, 0}, {0, -3, 0}}, {{2, -5, 1}, {2, 4, 1}, {0, 1, 0}},
        {{7, 0, 0}, {0, 0, 0}, {1, 0, 0}},  {{0, 0, 5}, {0, 0, 0}, {0, 0, 1}},   {{1, 2, 3}, {1, 2, 3}, {0, 1, 0}},
        {{1, 2, 3}, {1, 2, 3}, {0, 0, 2}},  {{-4, 5, 6}, {-4, 5, 6}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}, {1, 1, 0}}};
    while (cameras.size() < 99) {
        Placement camera = random_placement(random);
        camera.eye = on_grid(camera.eye);
        camera.target = on_grid(camera.target);
        const glm::vec3 view = camera.eye - camera.target;
        if (!has_clear_smallest(view)) continue;
        switch (cameras.size() % 3) {
            case 0:
                camera.up =
                    std::ldexp(random.below(2) == 0 ? 1.0F : -1.0F, static_cast<int>(random.below(9)) - 4) * view;
                break;
            case 1: camera.up = glm::vec3(0); break;
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
     [](Case& c, Recorder& out) { record(out, in_worlds_of_any_size(random_cameras(c.random, 500), c.random)); }},
    {"long and short up", [](Case& c, Recorder& out) { record(out, long_and_short_up(c.random)); }},
    {"far eye", [](Case& c, Recorder& out) { record(out, far_eyes(c.random)); }},
    {"almost parallel up", [](Case& c, Recorder& out) { record(out, almost_parallel(c.random)); }},
    {"degenerate", [](Case& c, Recorder& out) { record(out, degenerate(c.random)); }},
    {"picture",
     [](Case& c, Recorder& out) {
         const glm::mat4 view = ask<view_matrix>(out, c.vary.near(glm::vec3(3.4F, 2.5F, 4.4F), 0.8F),
                                                 glm::vec3(0.25F, 0.45F, 0), c.vary.near(glm::vec3(0.12F, 1, 0), 0.2F));
         out.image("colours", draw_scene(view));
     }},
};

}
