#pragma once

#include <kit/varied.hpp>
#include <umbral/record/variation.hpp>

#include "rays.hpp"

/// What the cases of raytracing/fragment-shader show.
namespace umbral::raytracing {

/// Mirror balls and matt ones on a polished floor, towards evening.
inline BallScene evening()
{
    BallScene scene;
    scene.look = {{0.6F, 1.7F, 6.6F},    {0.15F, 0.95F, 0},     0.34F,
                  {0.13F, 0.14F, 0.20F}, {0.62F, 0.27F, 0.13F}, {0.05F, 0.10F, 0.30F}};
    scene.balls = {{{0.1F, 1.15F, -0.6F, 1.15F}, glm::vec3(0.03F), 0.88F},
                   {{-2.05F, 0.75F, 0.1F, 0.75F}, {0.62F, 0.06F, 0.08F}, 0.18F},
                   {{2.1F, 0.85F, -0.2F, 0.85F}, {0.72F, 0.42F, 0.05F}, 0.28F},
                   {{-0.85F, 0.42F, 1.55F, 0.42F}, {0.04F, 0.30F, 0.36F}, 0.22F},
                   {{1.05F, 0.36F, 1.6F, 0.36F}, glm::vec3(0.02F), 0.85F},
                   {{0.15F, 0.2F, 2.35F, 0.2F}, {0.75F, 0.72F, 0.65F}, 0.1F},
                   {{-3.6F, 1.3F, -2.6F, 1.3F}, {0.08F, 0.16F, 0.42F}, 0.35F},
                   {{3.7F, 0.5F, 1.1F, 0.5F}, {0.30F, 0.42F, 0.10F}, 0.15F}};
    scene.tiles[0] = {0.62F, 0.56F, 0.48F};
    scene.tiles[1] = {0.06F, 0.05F, 0.055F};
    scene.floor_mirror = 0.2F;
    scene.floor_radius = 14;
    scene.light_position = {-4.5F, 7, 5.5F};
    scene.light_color = {1.35F, 1.15F, 0.92F};
    scene.levels = 6;
    return scene;
}

/// Matt balls: light, shadows and tiles only.
inline BallScene matt()
{
    BallScene scene;
    scene.look = {{-2.2F, 2.6F, 5.2F}, {0, 0.5F, 0}, 0.42F};
    scene.balls = {{{-0.9F, 0.8F, 0, 0.8F}, {0.8F, 0.3F, 0.2F}, 0},
                   {{0.9F, 0.5F, 0.6F, 0.5F}, {0.2F, 0.5F, 0.8F}, 0},
                   {{0.6F, 1.9F, -0.4F, 0.4F}, {0.4F, 0.7F, 0.3F}, 0}};
    scene.light_position = {2.5F, 4, 2};
    return scene;
}

/// Three mirrors that see each other, as deep as the levels allow. With one level the lamp is below the floor, which
/// throws a shadow upwards.
inline BallScene mirrors(int levels)
{
    BallScene scene;
    scene.look = {{0.4F, 1.4F, 4.6F}, {0, 0.8F, 0}, 0.36F};
    scene.balls = {{{-0.95F, 0.8F, 0, 0.8F}, {0.25F, 0.05F, 0.02F}, 0.8F},
                   {{0.85F, 0.8F, 0.2F, 0.8F}, {0.02F, 0.12F, 0.25F}, 0.9F},
                   {{0, 0.3F, 1.2F, 0.3F}, {0.05F, 0.2F, 0.03F}, 0.7F}};
    // Below the fourth ball: what is beyond the light throws no shadow.
    scene.balls.push_back({{0.3F, 3.4F, 0.6F, 0.5F}, {0.3F, 0.25F, 0.1F}, 0.2F});
    scene.light_position = {0.3F, 2.4F, 1.0F};
    scene.floor_mirror = 0.3F;
    if (levels == 1) {
        scene.light_position = {0.5F, -2.5F, 2.2F};
        scene.floor_radius = 1.2F;
    } else {
        scene.light_color = glm::vec3(1.8F);  // brighter than what can be shown: it is cut off once, at the end
    }
    scene.levels = levels;
    return scene;
}

/// A sponge from which a ball was cut, in low light.
inline SpongeScene carved()
{
    SpongeScene scene;
    scene.look = {{2.75F, 2.1F, 3.3F},   {0.02F, -0.08F, 0},    0.42F,
                  {0.20F, 0.23F, 0.32F}, {0.55F, 0.40F, 0.36F}, {0.07F, 0.11F, 0.24F}};
    scene.depth = 1;
    scene.ball = {0.95F, 0.9F, 0.85F, 1.15F};
    scene.sponge_color = {0.80F, 0.74F, 0.66F};
    scene.ball_color = {0.95F, 0.42F, 0.10F};
    scene.sun = {0.75F, 0.85F, 0.18F};
    scene.sun_color = {1.1F, 0.95F, 0.75F};
    return scene;
}

/// The cube, drilled as often as `depth` says; the ball is inside it, and seen through the holes. From the cube that
/// has none it cuts a corner.
inline SpongeScene drilled(int depth)
{
    SpongeScene scene;
    scene.look = {{-1.9F, 2.4F, 3.2F}, {0, 0, 0}, 0.38F};
    scene.depth = depth;
    scene.ball = depth == 0 ? glm::vec4(-0.8F, 0.9F, 0.8F, 0.75F) : glm::vec4(0.1F, 0, -0.1F, 0.72F);
    scene.sun = {-0.5F, 0.9F, 0.3F};
    return scene;
}

/// Another light, if inputs are to vary: no channel becomes zero, and none that is zero another number.
inline glm::vec3 varied_color(Variation& vary, glm::vec3 color)
{
    for (int channel = 0; channel < 3; ++channel) color[channel] = vary.scaled(color[channel], 1.4F);
    return color;
}

/// Seen from another side, and in other light, if inputs are to vary: the eye is as high and as far away.
inline RayLook varied(Variation& vary, RayLook look)
{
    look.eye = other_eye(vary, look.eye, look.target, 0.5F);
    look.half_height = vary.scaled(look.half_height, 1.1F);
    look.ambient = varied_color(vary, look.ambient);
    look.horizon = varied_color(vary, look.horizon);
    look.zenith = varied_color(vary, look.zenith);
    return look;
}

/// The lamp stays on its side of the floor, and before or behind the same balls.
inline BallScene varied(Variation& vary, BallScene scene)
{
    scene.look = varied(vary, scene.look);
    for (TracedBall& ball : scene.balls) ball.color = varied_color(vary, ball.color);
    for (glm::vec3& tile : scene.tiles) tile = varied_color(vary, tile);
    scene.light_position = vary.near(scene.light_position, 0.25F);
    return scene;
}

/// The ball keeps its size, so that it cuts the cube where it did, or nowhere.
inline SpongeScene varied(Variation& vary, SpongeScene scene)
{
    scene.look = varied(vary, scene.look);
    scene.ball += glm::vec4(vary.near(glm::vec3(0), 0.1F), 0);
    scene.sponge_color = varied_color(vary, scene.sponge_color);
    scene.ball_color = varied_color(vary, scene.ball_color);
    scene.sun = vary.near(scene.sun, 0.2F);
    return scene;
}

inline void give_random_light(Random& random, RayLook& look)
{
    look.ambient = random_color(random, 0.3F);
    look.horizon = random_color(random, 0.9F);
    look.zenith = random_color(random, 0.9F);
    look.half_height = random.uniform(0.3F, 0.8F);
}

/// Between a mirroring floor and a ball so large that it is all but flat: the ray goes to and fro more often than any
/// `levels` allow, and rounding does not grow.
inline void go_to_and_fro(Random& random, OneRay<BallScene>& ray)
{
    BallScene& scene = ray.scene;
    const float gap = random.uniform(0.3F, 0.6F);
    scene.balls = {{{0, 50 + gap, 0, 50}, random_color(random, 0.6F), random.uniform(0.8F, 0.95F)}};
    scene.floor_mirror = random.uniform(0.8F, 0.95F);
    scene.floor_radius = 12;
    scene.light_position = glm::vec3(2, 0, 2) * random.in_cube() + glm::vec3(0, 0.5F * gap, 0);
    scene.levels = 6;
    const float angle = random.uniform(0, 6.28F);
    const glm::vec3 aside(std::cos(angle), 0, std::sin(angle));
    const float slope = random.uniform(0.5F, 0.9F) * (random.below(2) == 0 ? -1.0F : 1.0F);
    scene.look.eye = 4.0F * aside + glm::vec3(0, random.uniform(0.2F, 0.8F) * gap, 0);
    scene.look.target = scene.look.eye + glm::vec3(-aside.x, slope, -aside.z);
    ray.place = {0, 0};
}

/// Rays into random scenes, most of them aimed at a ball or the floor; in most few levels, so that rounding does not
/// grow. Of three lamps one hangs low, between the balls or below the floor, and of ten one is in a ball. Of ten rays
/// one goes to and fro between two mirrors.
inline std::vector<OneRay<BallScene>> random_ball_rays(Random& random, int count)
{
    std::vector<OneRay<BallScene>> rays;
    for (int i = 0; i < count; ++i) {
        OneRay<BallScene> ray;
        BallScene& scene = ray.scene;
        give_random_light(random, scene.look);
        const std::uint32_t balls = random.below(9);
        for (std::uint32_t k = 0; k < balls; ++k) {
            const float radius = random.uniform(0.3F, 1);
            const glm::vec3 place = 1.8F * random.in_cube();
            const float mirror = random.below(3) == 0 ? 0.0F : random.uniform(0.2F, 0.9F);
            scene.balls.push_back(
                {{place.x, radius + std::abs(place.y), place.z, radius}, random_color(random, 0.6F), mirror});
        }
        scene.tiles[0] = random_color(random, 0.8F);
        scene.tiles[1] = random_color(random, 0.3F);
        scene.floor_mirror = random.below(2) == 0 ? 0.0F : random.uniform(0.1F, 0.5F);
        scene.floor_radius = random.uniform(2, 9);
        scene.light_color = 1.2F * random_color(random, 1);
        const glm::vec3 lamp = 3.0F * random.in_cube();
        scene.light_position = {lamp.x, random.below(3) == 0 ? lamp.y : 4 + std::abs(lamp.y), lamp.z};
        if (i % 10 == 3 && balls > 0) {
            const glm::vec4& round = scene.balls.front().sphere;
            scene.light_position = glm::vec3(round) + 0.4F * round.w * random.in_cube();
        }
        scene.levels = 1 + static_cast<int>(random.below(i % 3 == 0 ? 6 : 3));
        // The eye is farther away than any ball reaches.
        const float turn = random.uniform(0, 6.28F);
        scene.look.eye = {5 * std::cos(turn), random.uniform(0.5F, 3), 5 * std::sin(turn)};
        scene.look.target = glm::vec3(0, 0.7F, 0) + random.in_cube();
        ray.place = {random.uniform(-1.2F, 1.2F), random.uniform(-1, 1)};
        if (i % 2 == 0 && !scene.balls.empty()) {
            // At the last ball in the list, wherever its border is.
            const glm::vec4& ball = scene.balls.back().sphere;
            scene.look.target = glm::vec3(ball) + 0.7F * ball.w * random.in_cube();
            ray.place *= 0.05F;
        }
        if (i % 10 == 7) go_to_and_fro(random, ray);
        rays.push_back(ray);
    }
    return rays;
}

/// Into one of the smallest holes of a sponge that is drilled so often, from before its face. The sun shines upon the
/// face: where the hole is missing, there is light.
inline void aim_into_hole(Random& random, SpongeScene& scene, int depth, int axis)
{
    scene.depth = depth;
    const float cells = std::pow(3.0F, static_cast<float>(depth - 1));
    for (int k = 0; k < 3; ++k)
        scene.look.target[k] =
            2 / cells * (static_cast<float>(random.below(static_cast<std::uint32_t>(cells))) + 0.5F) - 1;
    scene.look.target[axis] = scene.look.eye[axis] < 0 ? -1.0F : 1.0F;
    scene.sun[axis] = std::copysign(scene.sun[axis], scene.look.target[axis]);
    scene.ball.w = random.uniform(0.3F, 0.7F);
}

/// The ray meets a face of the sponge all but along it, or the sun shines on the face all but along it.
inline void aim_along_face(Random& random, SpongeScene& scene, int axis, bool sun)
{
    const float side = random.below(2) == 0 ? -1.0F : 1.0F;
    glm::vec3 place = 0.9F * random.in_cube();
    place[axis] = side;
    glm::vec3 along = random.unit_vector();
    along[axis] = 0;
    along = normalize(along);
    scene.look.target = place;
    scene.depth = static_cast<int>(random.below(2));
    scene.ball.w = random.uniform(0.2F, 0.5F);
    if (sun) {
        scene.look.eye[axis] = side * (0.5F + std::abs(scene.look.eye[axis]));
        along[axis] = side * random.uniform(0.002F, 0.03F);
        scene.sun = along;
        scene.sun_color *= 2.0F;
    } else {
        along[axis] = side * random.uniform(0.028F, 0.05F);
        scene.look.eye = place + random.uniform(3, 8) * along;
    }
}

/// Into the hollow, which lies open in a face. Half of the sponges have no holes.
inline void aim_into_hollow(Random& random, SpongeScene& scene, int axis)
{
    scene.depth = std::max(static_cast<int>(random.below(6)) - 2, 0);
    glm::vec3 centre = 0.7F * random.in_cube();
    centre[axis] = scene.look.eye[axis] < 0 ? -1.0F : 1.0F;
    scene.ball = glm::vec4(centre, random.uniform(0.5F, 0.9F));
    scene.look.target = centre + 0.4F * scene.ball.w * random.in_cube();
    scene.look.eye[axis] += 2 * centre[axis];
}

/// Of ten rays two go anywhere, one into a hollow, three into the smallest holes, one comes from afar, one from within
/// the hollow, and two have a ray or the sun along a face.
inline std::vector<OneRay<SpongeScene>> random_sponge_rays(Random& random, int count)
{
    std::vector<OneRay<SpongeScene>> rays;
    for (int i = 0; i < count; ++i) {
        OneRay<SpongeScene> ray;
        SpongeScene& scene = ray.scene;
        give_random_light(random, scene.look);
        scene.depth = static_cast<int>(random.below(i % 3 == 0 ? 5 : 3));
        scene.ball = glm::vec4(random.in_cube(), random.uniform(0.3F, 1.1F));
        scene.sponge_color = random_color(random, 0.8F) + glm::vec3(0.1F);
        scene.ball_color = random_color(random, 0.8F) + glm::vec3(0.1F);
        scene.sun = random.unit_vector();
        scene.sun_color = 1.2F * random_color(random, 1);
        scene.look.eye = random.uniform(3, 8) * random.unit_vector();
        scene.look.target = 0.6F * random.in_cube();
        ray.place = 0.5F * glm::vec2(random.in_cube());
        const int kind = i % 10;
        const auto axis = static_cast<int>(random.below(3));
        if (kind >= 2) ray.place = {0, 0};
        if (kind == 2) aim_into_hollow(random, scene, axis);
        if (kind >= 3 && kind <= 5) aim_into_hole(random, scene, kind == 3 ? 3 : 4, axis);
        if (kind == 6) scene.look.eye = random.uniform(12, 23) * random.unit_vector();
        if (kind == 7) {
            scene.ball.w = random.uniform(0.5F, 1.1F);
            scene.look.eye = glm::vec3(scene.ball) + 0.5F * scene.ball.w * random.in_cube();
            scene.look.target = scene.look.eye + random.unit_vector();
        }
        if (kind >= 8) aim_along_face(random, scene, axis, kind == 9);
        scene.sun = normalize(scene.sun);
        rays.push_back(ray);
    }
    return rays;
}

}
