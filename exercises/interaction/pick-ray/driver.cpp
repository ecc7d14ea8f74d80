#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>
#include <umbral/record/not_finite.hpp>

#include "clicks.hpp"
#include "panel.hpp"

namespace umbral {
namespace {

using namespace interaction;

constexpr float endless = std::numeric_limits<float>::infinity();
constexpr projections::ViewFrame world{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};

void record_ray(Recorder& out, const PickView& view, const glm::ivec2& pixel)
{
    const Ray ray = ask<pick_ray>(out, view, pixel);
    out.append("origin", ray.origin);
    out.append("direction", ray.direction);
    out.append("t_min", ray.t_min);
    out.append("t_max", recordable(ray.t_max));
}

void record_clicks(Recorder& out, const std::vector<Click>& clicks)
{
    out.columns("pixel", "column, row");
    for (const auto& [cursor, window, framebuffer] : clicks)
        out.append("pixel", ask<pick_pixel>(out, cursor, window, framebuffer));
}

void record_borders(Recorder& out, Random& random)
{
    record_clicks(out, clicks_at_borders(random, 48));
    record_clicks(out, clicks_beside_borders(random, 32));
    record_clicks(out, clicks_at_whole_places(random, 40));
    record_clicks(out, clicks_at_odd_scales(random, 36));
}

// The course's view, and others that a hand can work out: pictures of few pixels, cameras along the axes.
void record_by_hand(Variation& vary, Recorder& out)
{
    // Turned by quarters of a turn, in which nothing is rounded, elsewhere, and with other planes.
    const auto record_turned = [&](PickView view, const glm::ivec2& pixel) {
        const ExactMap map = vary.exact_map(0);
        for (glm::vec3* const axis : {&view.frame.x, &view.frame.y, &view.frame.z}) *axis = map.place(*axis);
        view.frame.origin = vary.near(view.frame.origin, 0.5F);
        const float away = vary.scaled(1.0F, 1.3F);
        view.frustum.near_plane *= away;
        view.frustum.far_plane *= away;
        record_ray(out, view, pixel);
    };
    const PickView course{world, {-4.0F / 3, 4.0F / 3, -1, 1, 1, 100}, {640, 480}};
    for (const glm::ivec2& pixel : {glm::ivec2(0, 0), {320, 240}, {639, 479}, {639, 0}, {100, 50}})
        record_turned(course, pixel);
    const PickView small{world, {-2, 2, -2, 2, 2, 10}, {4, 2}};
    for (const glm::ivec2& pixel : {glm::ivec2(0, 0), {1, 0}, {2, 0}, {3, 1}}) record_turned(small, pixel);
    const PickView one{{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {5, 2, -1}}, {-1, 1, -1, 1, 0.5F, endless}, {1, 1}};
    record_turned(one, {0, 0});
    const PickView nine{{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 3, 0}}, {-3, 3, -3, 3, 2, endless}, {3, 3}};
    for (const glm::ivec2& pixel : {glm::ivec2(1, 1), {0, 1}, {1, 2}, {2, 0}, {2, 1}}) record_turned(nine, pixel);
    const PickView aside{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, 8}}, {1, 5, 0, 2, 4, 12}, {2, 1}};
    record_turned(aside, {0, 0});
    record_turned(aside, {1, 0});
}

void record_random(Recorder& out, Random& random)
{
    for (int i = 0; i < 200; ++i) {
        const PickView view = random_pick_view(random);
        record_ray(out, view, random_pixel(view.picture, random));
    }
}

// Pixels that a drag comes to outside of the window; and far beyond, up to the largest int, where neither twice the
// pixel is an int nor its distance from the picture's border.
void record_outside(Recorder& out, Random& random)
{
    constexpr int most = std::numeric_limits<int>::max();
    for (int i = 0; i < 60; ++i) {
        const PickView view = random_pick_view(random);
        glm::ivec2 pixel = random_pixel(view.picture, random);
        const int near_by = random_between(1, 1500, random);
        const int far_off = most - static_cast<int>(std::exp2(random.uniform(0, 30.99F)));
        int& place = pixel[i % 2];
        if (i % 3 == 2)
            place = i % 4 < 2 ? -far_off : far_off;
        else
            place = i % 4 < 2 ? -near_by : view.picture[i % 2] - 1 + near_by;
        record_ray(out, view, pixel);
    }
}

/// One of the 24 frames along the world's axes, where rows and columns of rotations are exact.
projections::ViewFrame axis_frame(Random& random)
{
    const auto along = random.below(3);
    const float side = random.below(2) == 0 ? 1 : -1;
    const float other = random.below(2) == 0 ? 1 : -1;
    glm::vec3 x(0);
    glm::vec3 y(0);
    x[static_cast<int>(along)] = side;
    y[static_cast<int>((along + 1 + random.below(2)) % 3)] = other;
    return {x, y, cross(x, y), glm::vec3(0)};
}

// Narrow windows far off the middle, in pictures of up to 2^25 pixels across (tiles of a wall of screens), seen from
// far from the world's origin; near planes from 1e-9 to 1e6 away.
void record_telescopes(Recorder& out, Random& random)
{
    for (int i = 0; i < 200; ++i) {
        PickView view{axis_frame(random), {}, {}};
        view.frame.origin = std::exp2(random.uniform(10, 20)) * random.unit_vector();
        const float near_plane = std::pow(10.0F, i % 2 == 0 ? random.uniform(-2, 0) : random.uniform(-9, 6));
        const float left = near_plane * random.uniform(-1.5F, 1.5F);
        const float bottom = near_plane * random.uniform(-1.5F, 1.5F);
        const float width = near_plane * std::exp2(random.uniform(-12, 0));
        view.frustum = {
            left, left + width, bottom, bottom + 0.7F * width, near_plane, near_plane * random.uniform(2, 1e6F)};
        view.picture.x = static_cast<int>(std::exp2(random.uniform(10, 25)));
        view.picture.y = static_cast<int>(std::exp2(random.uniform(10, 25)));
        record_ray(out, view, random_pixel(view.picture, random));
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record_by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(out, c.random); }},
    {"outside", [](Case& c, Recorder& out) { record_outside(out, c.random); }},
    {"telescopes", [](Case& c, Recorder& out) { record_telescopes(out, c.random); }},
    {"clicks", [](Case& c, Recorder& out) { record_clicks(out, random_clicks(c.random, 200)); }},
    {"borders", [](Case& c, Recorder& out) { record_borders(out, c.random); }},
    {"no window", [](Case& c, Recorder& out) { record_clicks(out, clicks_without_a_window(c.random, 48)); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
