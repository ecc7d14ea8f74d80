#include <kit/picture.hpp>
#include <tuple>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "cameras.hpp"
#include "lights.hpp"
#include "saturn.hpp"

namespace umbral {
namespace {

using namespace raytracing;

void record_direction(Recorder& out, const PrimaryCamera& camera, int width, int height, const glm::vec2& place,
                      std::string_view name = "direction")
{
    out.append(name, ask<primary_ray>(out, camera, width, height, place).direction);
}

void record_by_hand(Variation& vary, Recorder& out)
{
    const float right_angle = 1.5707964F;
    const PrimaryCamera plain{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, right_angle};
    const PrimaryCamera east{{1, 2, 3}, {6, 2, 3}, {0, 3, 0}, right_angle};
    const PrimaryCamera down{{0, 5, 0}, {0, 1, 0}, {0, 0, -1}, right_angle};
    const auto record = [&](PrimaryCamera camera, int width, int height, const glm::vec2& place) {
        // Turned by quarters of a turn, which round nothing.
        const ExactMap map = vary.exact_map(0);
        for (glm::vec3* const vector : {&camera.eye, &camera.target, &camera.up}) *vector = map.place(*vector);
        const Ray ray = ask<primary_ray>(out, camera, width, height, place);
        out.append("direction", ray.direction);
        out.append("origin", glm::vec4(ray.origin + ray.t_min * ray.direction, 1 / ray.t_max));
        out.columns("origin", "x at t_min, y at t_min, z at t_min, 1/t_max");
    };
    for (const glm::vec2& place : {glm::vec2(0.5F, 0.5F), {320.5F, 240.5F}, {639.5F, 479.5F}, {0.5F, 479.5F}})
        record(plain, 640, 480, place);
    for (const PrimaryCamera& camera : {plain, east, down})
        for (const glm::vec2& place : {glm::vec2(2, 1), {4, 1}, {2, 0}, {3, 1.5F}, {0, 2}, {5, -1}})
            record(camera, 4, 2, place);
}

// Targets right before the eye and far away: how far is no part of the answer. Of four cameras one is in a tiny world,
// and one stands nearly or exactly upright.
void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        const float distance = power_of_ten(random, i % 4 == 0 ? -9.0F : -3.0F, i % 4 == 0 ? -3.0F : 3.0F);
        const float reach = i % 4 == 0 ? 100 * distance : 5.0F;
        const PrimaryCamera camera = i % 4 == 2 ? upright_camera(random, reach, distance)
                                                : random_camera(random, reach * random.in_cube(), distance);
        const int width = 1 + static_cast<int>(random.below(800));
        const int height = std::max(1, width * 3 / static_cast<int>(2 + random.below(5)));
        record_direction(out, camera, width, height, random_place(random, width, height));
    }
}

// Pictures of all shapes, and fields of view from narrow to the widest that there is, at what is near and far. Each
// camera is asked for the same place of two pictures of other heights.
void record_shapes(Random& random, Recorder& out)
{
    const glm::ivec2 sizes[] = {{1, 1}, {7, 3}, {3, 8}, {1, 500}, {500, 1}, {1920, 1080}, {1281, 721}, {20000, 15000}};
    for (int i = 0; i < 48; ++i) {
        PrimaryCamera camera = random_camera(random, random.in_cube(), power_of_ten(random, -6, 3));
        const float wide = i % 3 == 1 ? random.uniform(1.6F, 2.97F) : random.uniform(2.97F, 3);
        camera.fovy = i % 3 == 0 ? random.uniform(0.05F, 0.4F) : i % 12 == 2 ? 3.0F : wide;
        const glm::ivec2 size = sizes[i % 8];
        const glm::vec2 place = random_place(random, size.x, size.y);
        record_direction(out, camera, size.x, size.y, place);
        record_direction(out, camera, size.x, size.y + 1 + static_cast<int>(random.below(7)), place);
    }
}

// What is up: of any length, oblique, nearly along the view, and nearly or exactly an axis. Every fourth camera is the
// one before, rolled.
void record_up(Random& random, Recorder& out)
{
    PrimaryCamera before;
    for (int i = 0; i < 80; ++i) {
        PrimaryCamera camera = random_camera(random, 3.0F * random.in_cube(), 2);
        if (i % 4 == 1) std::tie(camera.eye, camera.target) = std::tie(before.eye, before.target);
        before = camera;
        const glm::dvec3 view = normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
        const double side = random.below(2) == 0 ? 1 : -1;
        const double lean = i % 4 == 0 ? random.uniform(0.05F, 0.3F) : 1.0;
        camera.up = glm::vec3(side * view + lean * perpendicular_to(view, random));
        if (i % 4 == 2) camera = upright_camera(random, 3, 2);
        if (i % 4 == 3) camera = steep_camera(random, i / 4 % 3);
        camera.up *= std::pow(10.0F, random.uniform(-12, 12));
        record_direction(out, camera, 64, 48, random_place(random, 64, 48));
    }
}

// Up vectors so near the view that a cross product of float numbers has lost two digits and more of their frame.
void record_steep(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const float away = std::pow(10.0F, random.uniform(0, 5));
        PrimaryCamera camera = random_camera(random, away * random.in_cube(), away * random.uniform(0.1F, 2));
        const glm::dvec3 view = normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
        const double lean = std::pow(10.0F, random.uniform(-2.9F, -1.7F));
        const double side = random.below(2) == 0 ? 1 : -1;
        camera.up = glm::vec3(side * view + lean * perpendicular_to(view, random));
        camera.up *= std::pow(10.0F, random.uniform(-3, 3));
        record_direction(out, camera, 64, 48, random_place(random, 64, 48));
    }
}

void record_far(Random& random, Recorder& out)
{
    for (const float away : {1e4F, 1e5F, 1e6F})
        for (int i = 0; i < 30; ++i)
            record_direction(out, random_camera(random, away * random.unit_vector(), 1e-3F * away), 64, 48,
                             random_place(random, 64, 48));
}

// Narrow views, in which a pixel is a few millionths wide, of things far away and far from the origin.
void record_telephoto(Random& random, Recorder& out)
{
    for (int i = 0; i < 150; ++i) {
        PrimaryCamera camera = random_camera(random, 1e5F * random.in_cube(), random.uniform(1e2F, 1e5F));
        camera.fovy = std::pow(10.0F, random.uniform(-4, -2));
        record_direction(out, camera, 512, 384, random_place(random, 512, 384));
    }
}

void record_samples(Random& random, Recorder& out)
{
    const auto record = [&](int x, int y, int n) {
        const std::vector<glm::vec2> places = ask<pixel_samples>(out, x, y, n);
        out.append("count", static_cast<std::uint32_t>(places.size()));
        for (std::size_t i = 0; i < static_cast<std::size_t>(n) * static_cast<std::size_t>(n); ++i)
            out.append("place", i < places.size() ? places[i] : glm::vec2(not_a_number));
    };
    record(0, 0, 1);
    record(3, 5, 2);
    record(7, 1, 9);
    record(0, 6, 16);
    // Pixels above and left of the picture too; then the next one of the row, and the same one cut once more.
    for (int i = 0; i < 8; ++i) {
        const int x = static_cast<int>(random.below(1280)) - 640;
        const int y = static_cast<int>(random.below(960)) - 480;
        const int n = 1 + i % 4;
        record(x, y, n);
        record(x + 1, y, n);
        record(x + 1, y, n + 1);
    }
}

// More samples than a byte can count, far right and far down in large pictures: what is added up step by step in float
// has drifted there.
void record_fine_grid(Random& random, Recorder& out)
{
    for (int i = 0; i < 8; ++i) {
        // No multiples of 4, of which the parts are short binary fractions that add up exactly.
        const int n =
            4 * (5 + static_cast<int>(random.below(i % 2 == 0 ? 3 : 10))) + 1 + static_cast<int>(random.below(3));
        const int x = (i % 4 < 2 ? 4000 : 0) + static_cast<int>(random.below(4000));
        const int y = (i % 4 < 2 ? 0 : 4000) + static_cast<int>(random.below(4000));
        const std::vector<glm::vec2> places = ask<pixel_samples>(out, x, y, n);
        for (std::size_t k = 0; k < static_cast<std::size_t>(n) * static_cast<std::size_t>(n); ++k)
            out.append("place", k < places.size() ? places[k] : glm::vec2(not_a_number));
    }
}

// Each camera is asked again with other light, and with other samples of the same.
void record_rendered(Random& random, Recorder& out)
{
    const glm::ivec3 kinds[] = {{1, 1, 1}, {5, 3, 1}, {3, 4, 2}, {4, 2, 3}, {2, 2, 5}, {6, 1, 4}, {1, 2, 9}};
    for (const glm::ivec3& kind : kinds) {
        const PrimaryCamera camera = random_camera(random, 2.0F * random.in_cube(), 3);
        record_light(out, camera, kind, {"waves", 25.0F * random.unit_vector()});
        const glm::vec3 waves = 25.0F * random.unit_vector();
        record_light(out, camera, kind, {"waves with darkness between them", waves});
        record_light(out, camera, kind + glm::ivec3(0, 0, 1), {"waves with darkness between them", waves});
        record_light(out, camera, kind, {"bright and dark stripes", 25.0F * random.unit_vector()});
    }
    // From faint to far brighter than the sun, in turns.
    for (int i = 0; i < 18; ++i) {
        const float lows[] = {-7, -2, 4.5F};
        const float brightness = i < 15 ? power_of_ten(random, lows[i % 3], lows[i % 3] + 3)
                                        : power_of_ten(random, i == 15 ? -30 : 7, i == 15 ? -7 : 30);
        record_even_light(out, "even", {2, 1, 1 + i % 5}, brightness * some_color(random));
    }
}

// So many rays for each pixel that a sum in float has lost three digits.
void record_many_rays(Random& random, Recorder& out)
{
    for (int i = 0; i < 12; ++i)
        record_even_light(out, "light", {1, 1, 60 + static_cast<int>(random.below(41))},
                          power_of_ten(random, -2, 2) * some_color(random));
}

void record_picture(Variation& vary, Recorder& out)
{
    const PrimaryCamera camera{
        vary.near(glm::vec3(1.2F, 1.25F, 5.6F), 0.8F), {0.12F, 0, 0}, {vary.near(0.36F, 0.3F), 1, 0}, 0.55F};
    ask_in_words(out, [] { return "render_picture(camera, 288, 192, 4, saturn_light)"; });
    out.image("saturn", encoded(render_picture(camera, 288, 192, 4, saturn_light)));
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record_by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"shapes", [](Case& c, Recorder& out) { record_shapes(c.random, out); }},
    {"up", [](Case& c, Recorder& out) { record_up(c.random, out); }},
    {"steep", [](Case& c, Recorder& out) { record_steep(c.random, out); }},
    {"far from the origin", [](Case& c, Recorder& out) { record_far(c.random, out); }},
    {"telephoto", [](Case& c, Recorder& out) { record_telephoto(c.random, out); }},
    {"samples", [](Case& c, Recorder& out) { record_samples(c.random, out); }},
    {"fine grid", [](Case& c, Recorder& out) { record_fine_grid(c.random, out); }},
    {"rendered", [](Case& c, Recorder& out) { record_rendered(c.random, out); }},
    {"many rays", [](Case& c, Recorder& out) { record_many_rays(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
