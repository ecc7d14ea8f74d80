#include <glm/gtc/matrix_transform.hpp>
#include <umbral/projections/fit.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../volumes.hpp"
#include "gallery.hpp"

namespace umbral {
namespace {

using namespace projections;

// Each number is a row of its own: in a row of several the largest would hide the errors of the others.
void record(Recorder& out, const ViewVolume& volume)
{
    for (const float side : {volume.left, volume.right, volume.bottom, volume.top}) out.append("window", side);
    for (const float plane : {volume.near_plane, volume.far_plane}) out.append("planes", plane);
}

void record(Recorder& out, const PlacedVolume& placed)
{
    record(out, placed.volume);
    out.append("eye", placed.eye);
}

constexpr PictureSize square{512, 512};

// Problem 3.5: the eye at side + 2.
void record_cubes(Variation& vary, Recorder& out)
{
    for (const float written : {2.0F, 1.0F, 4.0F, 0.5F, 10.0F}) {
        const float side = vary.scaled(written, 1.4F);
        record(out, ask<fit_cube>(out, side, side + vary.scaled(2.0F, 1.4F), square));
    }
    record(out, ask<fit_cube>(out, vary.scaled(2.0F, 1.4F), vary.scaled(20.0F, 1.2F), square));
}

// Problem 3.6 with both readings of its distance, and radius and distance of right-angled triangles.
void record_spheres(Variation& vary, Recorder& out)
{
    for (const auto& [radius, distance] : {std::pair(3.0F, 5.0F), {5, 13}, {1, 3}, {3, 8}, {2, 6}, {1, 100}}) {
        const float size = vary.scaled(radius, 1.3F);
        record(out, ask<fit_sphere>(out, size, size + vary.scaled(distance - radius, 1.3F), square));
    }
}

// Problem 3.7.
void record_pictures(Variation& vary, Recorder& out)
{
    for (const PictureSize& picture : {PictureSize{1280, 720},
                                       {720, 1280},
                                       {300, 100},
                                       {100, 300},
                                       {1, 2},
                                       {641, 640},
                                       {640, 641},
                                       {7, 7},
                                       {20'001, 20'000},
                                       {20'000, 20'001},
                                       {2, 1}}) {
        record(out, ask<fit_cube>(out, vary.scaled(2.0F, 1.4F), vary.scaled(4.0F, 1.4F), picture));
        record(out, ask<fit_sphere>(out, vary.scaled(3.0F, 1.2F), vary.scaled(5.0F, 1.2F), picture));
    }
}

// Problem 3.8.
void record_angles(Variation& vary, Recorder& out)
{
    for (const float fovy_degrees : {10.0F, 40.0F, 60.0F, 90.0F, 120.0F})
        record(out, ask<fit_cube_to_fovy>(out, vary.near(glm::vec3(1, 2, 3), 0.5F), vary.scaled(2.0F, 1.1F),
                                          vary.scaled(fovy_degrees, 1.1F), square));
    for (const PictureSize& picture : {PictureSize{300, 100}, {100, 300}})
        record(out, ask<fit_cube_to_fovy>(out, vary.near(glm::vec3(-1, 0, -5), 0.5F), vary.scaled(4.0F, 1.3F),
                                          vary.scaled(90.0F, 1.1F), picture));
}

// One in four is a panorama of a satellite: the product of its sides is no int.
PictureSize random_picture(Random& random)
{
    const std::uint32_t largest = random.below(4) == 0 ? 100'000 : 2000;
    const int width = 1 + static_cast<int>(random.below(largest));
    return {width, 1 + static_cast<int>(random.below(largest))};
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 100; ++i) {
        const float size = std::pow(10.0F, random.uniform(-2, 2));
        const float distance = size * (1 + std::pow(10.0F, random.uniform(-1, 1)));
        const PictureSize picture = random_picture(random);
        // The eye may be nearer to a cube's middle than the cube is long.
        record(out, ask<fit_cube>(out, size, distance - 0.5F * size, picture));
        record(out, ask<fit_sphere>(out, size, distance, picture));
        const float fovy_degrees = random.uniform(10, 150);
        record(out, ask<fit_cube_to_fovy>(out, 10.0F * random.in_cube(), size, fovy_degrees, picture));
    }
}

// Something that fits, and something that does not, in random order: a picture without pixels, a body without a size,
// an eye within it, no angle; and NaN, of which every comparison is false, whether it asks for good or for bad.
void record_refused(Random& random, Recorder& out)
{
    constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
    for (int i = 0; i < 36; ++i) {
        const int fault = i % 9;
        const bool early = i < 18;
        // What is tiny has a size too.
        const float size = std::pow(10.0F, random.uniform(-7, 2));
        const float distance = size * random.uniform(1.1F, 5);
        const float inside = early ? size : size * random.uniform(-1, 0.9F);
        const bool first = random.below(2) == 1;
        for (const bool is_bad : {first, !first}) {
            const auto bad = [&](int which) { return is_bad && fault == which; };
            const bool no_size = bad(8) && i % 2 == 0;
            const bool no_place = bad(8) && i % 2 == 1;
            const int none = early ? 0 : -100;
            const PictureSize picture{bad(0) ? none : 200, bad(1) ? none : 100};
            const float asked = bad(2) ? 0 : bad(3) ? -size : no_size ? not_a_number : size;
            const float from = bad(4) || bad(5) ? inside : no_place ? not_a_number : distance;
            if (fault <= 4 || fault == 8)
                record_refusal(out, "cube refused", [&] { return ask<fit_cube>(out, asked, 0.5F * from, picture); });
            if (fault <= 3 || fault == 5 || fault == 8)
                record_refusal(out, "sphere refused", [&] { return ask<fit_sphere>(out, asked, from, picture); });
            if (fault <= 3 || fault >= 6)
                record_refusal(out, "angle refused", [&] {
                    // Next to nothing, and nearly 180 degrees, are angles too.
                    const float good = early ? 50.0F : fault % 2 == 0 ? 179.99995F : 5e-5F;
                    const float angle = bad(6) ? 180.0F : bad(7) ? 0.0F : no_place ? not_a_number : good;
                    return ask<fit_cube_to_fovy>(out, glm::vec3(1), asked, angle, picture);
                });
        }
    }
}

// Eyes 10^-1 to 10^-6 of a radius above the surface, of spheres as small and as large as floats have them.
void record_close(Random& random, Recorder& out)
{
    for (int i = 0; i < 100; ++i) {
        const float radius = std::pow(10.0F, random.uniform(-25, 25));
        const float above = std::pow(10.0F, random.uniform(-6, i % 4 == 0 ? 6.0F : -1.0F));
        record(out, ask<fit_sphere>(out, radius, radius * (1 + above), random_picture(random)));
    }
}

void record_extreme_angles(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const float rest = std::pow(10.0F, random.uniform(-4, -0.5F));
        record(out,
               ask<fit_cube_to_fovy>(out, glm::vec3(0), 2.0F, i % 3 == 0 ? rest : 180 - rest, random_picture(random)));
    }
}

// A cube and a sphere in pictures of three shapes. Whatever is too large is cut, whatever is too small has a margin.
void draw_gallery(Variation& vary, Recorder& out)
{
    const Gallery gallery(vary.near(0.0F, 1.2F));
    const float from_cube = vary.near(4.0F, 0.8F);
    gallery.draw_cube(0, from_cube, ask<fit_cube>(out, 2.0F, from_cube, gallery.panel_size(0)));
    const float from_ball = vary.near(2.6F, 0.6F);
    gallery.draw_ball(1, from_ball, ask<fit_sphere>(out, 1.0F, from_ball, gallery.panel_size(1)));
    const PlacedVolume placed =
        ask<fit_cube_to_fovy>(out, glm::vec3(0), 2.0F, vary.near(75.0F, 20.0F), gallery.panel_size(2));
    gallery.draw_cube(2, placed.eye.z, placed.volume);
    out.image("colours", gallery.picture());
}

}

const Driver driver = {
    {"cube", [](Case& c, Recorder& out) { record_cubes(c.vary, out); }},
    {"sphere", [](Case& c, Recorder& out) { record_spheres(c.vary, out); }},
    {"pictures", [](Case& c, Recorder& out) { record_pictures(c.vary, out); }},
    {"angle", [](Case& c, Recorder& out) { record_angles(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"refused", [](Case& c, Recorder& out) { record_refused(c.random, out); }},
    {"close", [](Case& c, Recorder& out) { record_close(c.random, out); }},
    {"extreme angles", [](Case& c, Recorder& out) { record_extreme_angles(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { draw_gallery(c.vary, out); }},
};

}
