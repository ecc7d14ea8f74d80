#include <kit/picture.hpp>
#include <tuple>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../rays.hpp"
#include "saturn.hpp"

namespace umbral {
namespace {

using namespace raytracing;

void record_direction(Recorder& out, const PrimaryCamera& camera, int width, int height, const glm::vec2& place,
                      std::string_view name = "direction")
{
    out.append(name, ask<primary_ray>(out, camera, width, height, place).direction);
}

/// A camera that looks at a place in its surroundings, upright or not.
PrimaryCamera random_camera(Random& random, const glm::vec3& place, float distance)
{
    PrimaryCamera camera;
    camera.eye = place;
    const glm::dvec3 view = normalize(glm::dvec3(random.unit_vector()));
    camera.target = glm::vec3(glm::dvec3(place) + double{distance} * view);
    const double along = random.uniform(-0.9F, 0.9F);
    camera.up = glm::vec3(along * view + std::sqrt(1 - along * along) * perpendicular_to(view, random));
    camera.fovy = random.uniform(0.3F, 2);
    return camera;
}

// One in four lies outside the picture.
glm::vec2 random_place(Random& random, int width, int height)
{
    const glm::vec2 size(width, height);
    const float x = random.uniform();
    const glm::vec2 place = glm::vec2(x, random.uniform()) * size;
    return random.below(4) == 0 ? 2.0F * place - 0.5F * size : place;
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

// Targets right before the eye and far away: how far is no part of the answer.
void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        const PrimaryCamera camera =
            random_camera(random, 5.0F * random.in_cube(), std::pow(10.0F, random.uniform(-3, 3)));
        const int width = 1 + static_cast<int>(random.below(800));
        const int height = std::max(1, width * 3 / static_cast<int>(2 + random.below(5)));
        record_direction(out, camera, width, height, random_place(random, width, height));
    }
}

// Pictures of all shapes, and fields of view from narrow to very wide, at what is near and far.
void record_shapes(Random& random, Recorder& out)
{
    const glm::ivec2 sizes[] = {{1, 1}, {7, 3}, {3, 8}, {1, 500}, {500, 1}, {1920, 1080}, {1281, 721}, {6, 4}};
    for (int i = 0; i < 80; ++i) {
        PrimaryCamera camera = random_camera(random, random.in_cube(), std::pow(10.0F, random.uniform(-3, 3)));
        camera.fovy = i % 2 == 0 ? random.uniform(0.05F, 0.4F) : random.uniform(1.6F, 2.97F);
        const glm::ivec2 size = sizes[i % 8];
        record_direction(out, camera, size.x, size.y, random_place(random, size.x, size.y));
    }
}

// Looks along an axis, with an up vector that leans by 0.001 to 0.05 from it: its products with the view are exact.
PrimaryCamera steep_camera(Random& random, int axis)
{
    glm::vec3 view(0);
    view[axis] = random.below(2) == 0 ? 1.0F : -1.0F;
    PrimaryCamera camera;
    camera.eye = glm::vec3(random.below(9), random.below(9), random.below(9));
    camera.target = camera.eye + 2.0F * view;
    camera.up = random.below(2) == 0 ? view : -view;
    const float lean = std::pow(10.0F, random.uniform(-2.9F, -1.3F));
    const float angle = random.uniform(0, 6.28F);
    camera.up[(axis + 1) % 3] = lean * std::cos(angle);
    camera.up[(axis + 2) % 3] = lean * std::sin(angle);
    camera.fovy = random.uniform(0.3F, 2);
    return camera;
}

// What is up: of any length, oblique, and nearly along the view. Every fourth camera is the one before, rolled.
void record_up(Random& random, Recorder& out)
{
    PrimaryCamera before;
    for (int i = 0; i < 80; ++i) {
        PrimaryCamera camera = random_camera(random, 3.0F * random.in_cube(), 2);
        if (i % 4 == 1) std::tie(camera.eye, camera.target) = std::tie(before.eye, before.target);
        before = camera;
        const glm::dvec3 view = normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
        const double side = random.below(2) == 0 ? 1 : -1;
        const double lean = i % 2 == 0 ? random.uniform(0.05F, 0.3F) : 1.0;
        camera.up = glm::vec3(side * view + lean * perpendicular_to(view, random));
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
    for (int i = 0; i < 12; ++i)
        record(static_cast<int>(random.below(1280)) - 640, static_cast<int>(random.below(480)), 1 + i % 5);
}

// Light as bright as the sun beside a lamp's, the same everywhere: the mean is this light.
void record_sun(Recorder& out)
{
    const glm::vec3 sun(65'536, 20'000, 1.25F);
    ask_in_words(out, [] { return "render_picture(camera, 3, 2, 4, light of {65536, 20000, 1.25} everywhere)"; });
    const Grid<glm::vec3> picture = render_picture({}, 3, 2, 4, [&](const Ray&) { return sun; });
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            for (int channel = 0; channel < 3; ++channel)
                out.append("sun", picture.contains(x, y) ? picture.at(x, y)[channel] : not_a_number);
}

// A small picture of light that changes fast within a pixel, so that each sample counts; or, `with_dark`, is 0 along
// many rays, for some or all channels. `kind`: width, height and n.
void record_waves(Recorder& out, const PrimaryCamera& camera, const glm::ivec3& kind, const glm::vec3& waves,
                  bool with_dark)
{
    std::uint32_t asked = 0;
    const LightAlongRay light_along = [&](const Ray& ray) {
        ++asked;
        const glm::vec3 d = ray.direction + 0.1F * (ray.origin - camera.eye);
        if (with_dark) return 4.0F * max(glm::vec3(0), sin(glm::vec3(0, 0.5F, 1) + dot(waves, d)));
        return glm::vec3(4 + 4 * std::sin(dot(waves, d)), 0.5F + 0.5F * d.x, std::exp(2 * d.y));
    };
    ask_in_words(out, [&] {
        return "render_picture(camera, " + std::to_string(kind.x) + ", " + std::to_string(kind.y) + ", " +
               std::to_string(kind.z) + (with_dark ? ", waves with darkness between them)" : ", waves)");
    });
    const Grid<glm::vec3> picture = render_picture(camera, kind.x, kind.y, kind.z, light_along);
    out.columns("size", "width, height");
    out.append("size", glm::vec2(picture.width, picture.height));
    out.append("rays", asked);
    for (int y = 0; y < kind.y; ++y)
        for (int x = 0; x < kind.x; ++x)
            out.append("light", picture.contains(x, y) ? picture.at(x, y) : glm::vec3(not_a_number));
}

// Each camera is asked again with other light, and with other samples of the same.
void record_rendered(Random& random, Recorder& out)
{
    const glm::ivec3 kinds[] = {{1, 1, 1}, {5, 3, 1}, {3, 4, 2}, {4, 2, 3}, {2, 2, 5}, {6, 1, 4}, {1, 2, 9}};
    for (const glm::ivec3& kind : kinds) {
        const PrimaryCamera camera = random_camera(random, 2.0F * random.in_cube(), 3);
        record_waves(out, camera, kind, 25.0F * random.unit_vector(), false);
        const glm::vec3 waves = 25.0F * random.unit_vector();
        record_waves(out, camera, kind, waves, true);
        record_waves(out, camera, kind + glm::ivec3(0, 0, 1), waves, true);
    }
    record_sun(out);
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
    {"rendered", [](Case& c, Recorder& out) { record_rendered(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
