#pragma once

#include <kit/varied.hpp>
#include <utility>

#include "scenes.hpp"

/// Pixels that the unit is asked for one by one.
namespace umbral::raytracing {

/// A question about one pixel.
struct PixelQuestion {
    std::string name;
    StillLife scene;
    LensCamera camera;
    PictureSize size;
    glm::ivec2 pixel;
    int samples = 12;
};

/// Four panels that shine, so large that each pixel sees one of them: no chance takes part.
inline StillLife panels()
{
    StillLife life({{0.5F, 0.75F, 0.25F}, {0.5F, 0.75F, 0.25F}, {0.5F, 1, 2}});
    const auto panel = [&](float x, float y, glm::vec3 emitted, glm::vec3 albedo) {
        life.add(SolidQuad{{x, y, -4}, {2, 0, 0}, {0, 2, 0}}, Paint{albedo, emitted});
    };
    panel(-2, 0, {1, 0.25F, 0.5F}, glm::vec3(0));
    panel(0, 0, {0, 0, 0}, {0.5F, 0.25F, 0.125F});
    panel(-2, -2, {2, 3, 0.5F}, {0.25F, 0.5F, 0.5F});
    return life;
}

/// With a pinhole, a still scene, and pixels within one panel, or the sky. Along x there are twice as many.
inline std::vector<PixelQuestion> sharp_pixels(Random& random)
{
    const LensCamera camera = camera_towards({0, 0, 0}, {0, 0, -1}, 0.5F, {0, 2, 1, 1});
    const PictureSize size{8, 4};
    std::vector<PixelQuestion> questions;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) questions.push_back({"", panels(), camera, size, glm::ivec2(x, y)});
    return in_random_order(random, std::move(questions));
}

/// A shining half-plane to the right of x = 0 or, with `above`, above y = 0, at a depth, and behind it the dark.
inline StillLife half_plane(float depth, bool above)
{
    StillLife life({glm::vec3(0.1F), glm::vec3(0.1F), glm::vec3(0)});
    life.add(above ? SolidQuad{{-50, 0, -depth}, {100, 0, 0}, {0, 50, 0}}
                   : SolidQuad{{0, -50, -depth}, {50, 0, 0}, {0, 100, 0}},
             Paint{glm::vec3(0), {1, 0.5F, 2}});
    return life;
}

/// A shining ball that flies to the right, before this sky.
inline StillLife flying_ball(const glm::vec3& centre, float radius, const glm::vec3& velocity, float sky = 0.05F)
{
    StillLife life({glm::vec3(sky), glm::vec3(sky), glm::vec3(0)});
    life.add(SolidBall{centre, radius, velocity}, Paint{glm::vec3(0), {2, 1, 0.5F}});
    return life;
}

/// A wall whose spot that the lens sees, out of focus, is lit through a hole that images it on the lamp: each point of
/// the spot by another part of the lamp. If the lens's numbers are used again for the lamp, far too much light is
/// found, or far too little.
inline StillLife wall_behind_a_hole()
{
    StillLife life({glm::vec3(0), glm::vec3(0), {0.02F, 0.01F, 0.03F}});
    life.add(SolidQuad{{-3, -3, -6}, {6, 0, 0}, {0, 6, 0}}, Paint{{0.8F, 0.6F, 0.4F}});
    constexpr float hole = 0.075F;
    const auto screen = [&](glm::vec2 corner, glm::vec2 size) {
        life.add(SolidQuad{{corner, 0.5F}, {size.x, 0, 0}, {0, size.y, 0}}, Paint{glm::vec3(0)});
    };
    screen({-2, -2}, {2 - hole, 4});
    screen({hole, -2}, {2 - hole, 4});
    screen({-hole, -2}, {2 * hole, 2 - hole});
    screen({-hole, hole}, {2 * hole, 2 - hole});
    life.add_lamp({{-0.5F, 0.5F, 7}, {1, 0, 0}, {0, -1, 0}, {500, 400, 600}});
    return life;
}

/// Pixels whose light is a mean: over the pixel, the lens, the time, the lamp, and over several of them at once.
inline std::vector<PixelQuestion> mean_pixels()
{
    const auto camera = [](const Optics& optics) { return camera_towards({0, 0, 0}, {0, 0, -1}, 0.5F, optics); };
    const PictureSize size{8, 8};
    const PictureSize fine{800, 800};  // a pixel is a point of it, nearly
    // The edge of a half-plane crosses a pixel of which the camera is turned aside.
    LensCamera turned = camera({});
    turned.eye = {0.30F, 0.22F, 0};
    LensCamera lens = camera({0.4F, 2, 0, 0});
    lens.eye = {0.25F, 0.15F, 0};
    LensCamera sharp = camera({0.4F, 4, 0, 0});
    sharp.eye = {0.30F, 0, 0};
    StillLife lit({glm::vec3(0.2F), glm::vec3(0.6F), {0.1F, 0.2F, 0.3F}});
    lit.add(SolidQuad{{-6, -1, -6}, {0, 0, 12}, {12, 0, 0}}, Paint{{0.8F, 0.5F, 0.3F}});
    lit.add(SolidBall{{0, -0.4F, -3}, 0.3F, {1, 0, 0}}, Paint{{0.3F, 0.6F, 0.9F}});
    lit.add_lamp({{-1, 1.5F, -4}, {2, 0, 0}, {0, 0, 2}, {4, 3, 2}});
    lit.add_lamp({{2, 0, -4}, {0, 0, 2}, {0, 1, 0}, {2, 4, 3}});
    StillLife ring({glm::vec3(0), glm::vec3(0), glm::vec3(0.01F)});
    ring.add(SolidQuad{{-6, -1, -6}, {0, 0, 12}, {12, 0, 0}}, Paint{{0.8F, 0.5F, 0.3F}});
    for (int i = 0; i < 20; ++i) {
        const float turn = 6.2831853F * static_cast<float>(i) / 20;
        const glm::vec3 colour(1.0F + static_cast<float>(i % 3), 4.0F - static_cast<float>(i % 4), 2);
        ring.add_lamp({{std::cos(turn) - 0.2F, 0.6F, std::sin(turn) - 3.2F}, {0.4F, 0, 0}, {0, 0, 0.4F}, colour});
    }
    const Optics both{0.25F, 2, 0, 1};
    // Seen only from a point of the lens beyond its rim.
    const StillLife beyond = flying_ball({-0.43F, -0.43F, -6}, 0.09F, glm::vec3(0));
    return {
        {"a pixel across an upright edge", half_plane(4, false), turned, size, {3, 3}},
        {"a pixel across an upright edge, by one ray", half_plane(4, false), turned, size, {3, 3}, 1},
        {"a pixel across a level edge", half_plane(4, true), turned, size, {4, 4}},
        {"an edge out of focus", half_plane(5, false), lens, size, {4, 4}},
        {"a level edge before the focus", half_plane(1, true), lens, size, {4, 4}},
        {"an edge in focus, seen by a wide lens", half_plane(4, false), sharp, size, {3, 4}},
        {"a ball that flies by", flying_ball({-1.2F, 0.1F, -4}, 0.5F, {2, 0, 0}), camera({0, 2, 0, 1}), size, {4, 3}},
        {"a ball that comes late",
         flying_ball({-2.0F, 0.1F, -4}, 0.6F, {2, 0, 0}),
         camera({0, 2, 0.5F, 1.5F}),
         size,
         {4, 3}},
        {"a ball while the shutter is open for a moment only",
         flying_ball({-1.6F, 0.1F, -4}, 0.3F, {2, 0, 0}),
         camera({0, 2, 0.8F, 0.8F}),
         size,
         {4, 3}},
        {"a small ball behind the focus", flying_ball({0.2F, -0.2F, -6}, 0.45F, {0, 0, 0}), camera(both), size, {4, 4}},
        {"a ball out of focus that flies by",
         flying_ball({-0.8F, -0.2F, -6}, 0.6F, {1.6F, 0, 0}),
         camera(both),
         size,
         {4, 4}},
        {"a ball that flies up and away",
         flying_ball({0.1F, -1.0F, -5}, 0.6F, {0, 1.5F, -1}),
         camera(both),
         size,
         {4, 4},
         32},
        {"a ball that the lens does not see", beyond, camera(both), fine, {400, 400}},
        {"a ball that the right of the lens sees from below",
         flying_ball({-0.25F, 0.25F, -6}, 0.3F, glm::vec3(0), 1),
         camera(both),
         fine,
         {400, 400},
         32},
        {"a ball that the left of the lens sees from below",
         flying_ball({0.25F, 0.25F, -6}, 0.3F, glm::vec3(0), 1),
         camera(both),
         fine,
         {400, 400},
         32},
        {"a sky that is lighter above, beside a wide lens",
         StillLife({{0.4F, 0.5F, 0.3F}, {2.2F, 2.5F, 1.8F}, glm::vec3(0)}),
         camera({0.5F, 0.5F, 0, 0}),
         fine,
         {400, 400}},
        {"a wall lit through a hole, behind the focus",
         wall_behind_a_hole(),
         camera({0.25F, 2, 0, 0}),
         fine,
         {400, 400},
         24},
        {"a wall lit through a hole, before the focus",
         wall_behind_a_hole(),
         camera({1, 12, 0, 0}),
         fine,
         {400, 400},
         24},
        {"a table under a ring of twenty lamps", ring, camera({}), size, {4, 6}, 4},
        {"a table under two lamps and a ball", lit, camera({0.1F, 3, 0, 1}), size, {4, 6}},
        {"the shadow of a ball that flies by", lit, camera({0, 3, -0.5F, 0.5F}), size, {4, 7}}};
}

/// Pixels whose rays all differ a little, without long tails: of a table under two lamps.
inline std::vector<PixelQuestion> promised_pixels()
{
    const std::vector<PixelQuestion> pixels = mean_pixels();
    return {pixels.end() - 2, pixels.end()};
}

}
