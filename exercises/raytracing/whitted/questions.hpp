#pragma once

#include <kit/channels.hpp>
#include <umbral/core/random.hpp>

#include "../rays.hpp"
#include "built_world.hpp"

/// Materials, lights and worlds whose answers follow from how they were made.
namespace umbral::raytracing::whitted {

inline glm::vec3 random_color(Random& random, float most = 1)
{
    const float red = random.uniform(0.05F, most);
    const float green = random.uniform(0.05F, most);
    return {red, green, random.uniform(0.05F, most)};
}

/// The same, or one of three times a colour in which one or two of red, green and blue are missing.
inline glm::vec3 random_light_color(Random& random, float most = 1)
{
    const glm::vec3 color = random_color(random, most);
    return random.below(3) > 0 ? color : some_channels(random, color);
}

/// Neither mirror nor glass. Nothing of it is black: its ambient light shows which lights are visible.
inline Material matt(Random& random)
{
    Material material;
    material.local = {random_color(random, 0.3F), random_color(random, 0.4F), random_color(random),
                      random_color(random), random.below(6) == 0 ? random.uniform(40, 100) : random.uniform(1, 40)};
    return material;
}

/// How much a surface mirrors or lets through, as a part of its light; every third time hardly anything.
inline float random_part(Random& random)
{
    return random.below(3) == 0 ? random.uniform(0.01F, 0.05F) : random.uniform(0.2F, 1);
}

/// A lamp about this far from the origin, or a sun, whose direction has any length.
inline lighting::Light random_light(Random& random, float distance)
{
    const glm::vec3 way = random.unit_vector();
    const bool is_place = random.below(2) == 0;
    const float reach = is_place ? distance * random.uniform(0.7F, 1.3F) : std::exp2(random.uniform(-40, 40));
    return {glm::vec4(reach * way, is_place ? 1 : 0), random_light_color(random, 2)};
}

/// A unit vector at this sine from `axis`.
inline glm::vec3 tilted(const glm::vec3& axis, double sine, Random& random)
{
    const glm::dvec3 along(axis);
    return glm::vec3(normalize(std::sqrt(1 - sine * sine) * along + sine * perpendicular_to(along, random)));
}

/// The sine of the angle between a normal and a direction; every fifth time the direction nearly lies in the surface,
/// and every tenth time it is the normal.
inline double random_sine(Random& random, float most)
{
    const double grazing = random.uniform(0.01F, 0.05F);
    const std::uint32_t kind = random.below(10);
    return kind < 2 ? std::sqrt(1 - grazing * grazing) : kind == 2 ? 0.0 : double{random.uniform(0, most)};
}

/// What light_towards is asked.
struct Look {
    BuiltWorld world;
    Hit hit;
    glm::vec3 v;
    int level = 1;
};

/// A point on a panel of this material, which has no edge near, looked at from either side. Every fourth panel is level
/// or upright: its normal is an axis.
inline Look look_at_panel(const Material& material, Random& random)
{
    glm::vec3 normal = random.unit_vector();
    if (random.below(4) == 0) {
        const auto axis = static_cast<glm::length_t>(random.below(3));
        const float side = normal[axis] < 0 ? -1.0F : 1.0F;
        normal = glm::vec3(0);
        normal[axis] = side;
    }
    const glm::vec3 u(8.0 * perpendicular_to(glm::dvec3(normal), random));
    const glm::vec3 v = 8.0F * normalize(cross(normal, u));
    const glm::vec3 position = 3.0F * random.in_cube();
    const glm::vec2 uv(random.uniform(0.3F, 0.7F), random.uniform(0.3F, 0.7F));
    // From how far away the point was found is no matter.
    const float t = std::exp2(random.uniform(-5, 10));
    Look look{{}, {t, position, normal, uv, material}, tilted(normal, random_sine(random, 0.95F), random)};
    if (random.below(2) == 0) look.v = -look.v;
    look.world.panels.push_back({position - uv.x * u - uv.y * v, u, v, material});
    look.world.levels = 3;
    return look;
}

/// A light and a ball in its way, and one that is not: beyond the light, behind the panel, or beside. The panel itself
/// is in nobody's way. Every third lamp is in its way by a small globe of its own, and before others the ball is near
/// the end of the way; of other lights some are far away,
/// or suns of long directions, and what is in their way is small and lies close to the point. Else what is in a sun's
/// way may be as far off as a mountain.
inline void add_shadow_pair(std::vector<Look>& looks, int kind, Random& random)
{
    Look dark = look_at_panel(matt(random), random);
    const glm::vec3 side = dot(dark.v, dark.hit.normal) > 0 ? dark.hit.normal : -dark.hit.normal;
    const glm::vec3 way = tilted(random.below(4) == 0 ? -side : side, 0.8 * random.uniform_double(), random);
    const bool is_place = kind % 2 == 0;
    const bool is_close = kind % 10 == 3 || kind % 10 == 4 || kind % 10 == 7 || kind % 10 == 8;
    const float small_number = random.uniform(2, 8);
    const float reach = is_place ? small_number : std::exp2(random.uniform(-30, 6));
    const float distance = !is_close ? reach : std::exp2(is_place ? small_number + 3 : random.uniform(7, 10));
    dark.world.sources.push_back(
        {is_place ? glm::vec4(dark.hit.position + distance * way, 1) : glm::vec4(distance * way, 0),
         random_light_color(random, 2)});
    const bool near_the_end = is_place && !is_close && random.below(3) > 0;
    const float share = near_the_end ? random.uniform(0.92F, 0.98F) : random.uniform(0.25F, 0.75F);
    const float on_the_way = is_place ? share * distance : std::exp2(random.uniform(0, 14));
    Ball ball{{}, random.uniform(0.1F, 0.3F), matt(random)};
    if (random.below(3) == 0) ball.material.refracted = 1;
    if (is_close)
        ball.radius = std::exp2(random.uniform(-12, -6));
    else if (near_the_end)
        ball.radius = 0.4F * (1 - share) * distance;
    else if (!is_place)
        ball.radius *= std::max(1.0F, on_the_way / 32);
    const float between = is_close ? (2 + share) * ball.radius : on_the_way;
    ball.centre = dark.hit.position + between * way;
    Look lit = dark;
    const float small = std::exp2(random.uniform(-8, -3));
    const float aside = 1.5F * ball.radius;
    const glm::vec3 beside(aside * glm::vec3(perpendicular_to(glm::dvec3(way), random)));
    switch (kind / 2 % 4) {
        case 0: ball.centre += beside; break;
        case 1: ball.centre = dark.hit.position - (0.5F + aside) * way; break;
        default: ball.centre = dark.hit.position + (is_place ? 1.25F * distance + 1 : -0.8F - aside) * way;
    }
    Ball blocking = ball;
    blocking.centre = dark.hit.position + between * way;
    if (kind % 6 == 0) blocking = {glm::vec3(dark.world.sources.back().position), small, ball.material};
    dark.world.balls.push_back(blocking);
    lit.world.balls.push_back(ball);
    const bool swapped = random.below(2) == 1;
    looks.push_back(swapped ? lit : dark);
    looks.push_back(swapped ? dark : lit);
}

/// Up to five lights, or many dim ones, on a panel with a few balls about it; half of them with a texture, whose
/// coordinates may lie outside [0, 1].
inline Look many_lights(Random& random)
{
    Material material = matt(random);
    material.texture = random.below(2) * (1 + random.below(5));
    Look look = look_at_panel(material, random);
    look.hit.uv += 2.0F * glm::vec2(random.in_cube());
    look.world.global = random_color(random, 0.3F);
    const std::uint32_t count = random.below(3) == 0 ? 9 + random.below(16) : random.below(6);
    for (std::uint32_t i = 0; i < count; ++i) {
        look.world.sources.push_back(random_light(random, 6));
        if (count > 5) look.world.sources.back().color *= 4 / static_cast<float>(count);
    }
    // The first one is seen mirrored, so that there is a highlight.
    if (count > 0) {
        const glm::vec3 way = normalize(glm::reflect(-look.v, look.hit.normal) + 0.3F * random.in_cube());
        look.world.sources.front().position = glm::vec4(2.0F * way, 0);
    }
    for (int i = 0; i < 4; ++i)
        look.world.balls.push_back({look.hit.position + 1.5F * random.unit_vector(), 0.5F, matt(random)});
    return look;
}

/// Lights that only add to what comes by other rays.
inline void add_lights(BuiltWorld& world, std::uint32_t count, Random& random)
{
    for (std::uint32_t i = 0; i < count; ++i) world.sources.push_back(random_light(random, 20));
}

/// A level, which is the highest in a quarter of the questions, and beyond that in an eighth.
inline void set_levels(Look& look, Random& random)
{
    look.world.levels = 2 + static_cast<int>(random.below(7));
    const auto below_the_highest = static_cast<std::uint32_t>(look.world.levels - 1);
    const std::uint32_t kind = random.below(8);
    look.level = kind < 2 ? look.world.levels : 1 + static_cast<int>(random.below(below_the_highest));
    if (kind == 2) look.level = look.world.levels + 1 + static_cast<int>(random.below(2));
}

/// A large ball that shines, so far away in this direction that only rays without end find it.
inline void add_far_off(Look& look, const glm::vec3& direction, float radius, Random& random)
{
    const float distance = std::exp2(random.uniform(6, 18));
    Material shining;
    shining.local.emission = random_color(random);
    const glm::vec3 aside = 0.4F * radius * random.in_cube();
    look.world.balls.push_back({look.hit.position + distance * (direction + aside), radius * distance, shining});
}

/// A mirror under a sky that differs in all directions.
inline Look mirror(Random& random, std::uint32_t lights)
{
    Material material = matt(random);
    material.mirrored = random_part(random);
    material.mirrored_color = random_light_color(random);
    Look look = look_at_panel(material, random);
    add_lights(look.world, lights, random);
    set_levels(look, random);
    return look;
}

/// An index of refraction above 1 or, as often, below; or 1.
inline float random_index(Random& random)
{
    const float above = random.uniform(1.1F, 2);
    const std::uint32_t kind = random.below(5);
    return kind == 0 ? 1 : kind < 3 ? above : 1 / above;
}

/// A surface between two media. There is nothing else, so that what is refracted is the sky's. Of half of them total
/// reflection is possible; these are most often just below its angle, so that the root is small, or above. Nearer than
/// a thousandth to it there is none.
inline Look interface_of_glass(Random& random, std::uint32_t lights)
{
    Material material = matt(random);
    material.refracted = random_part(random);
    material.refracted_color = random_light_color(random);
    material.index = random_index(random);
    const bool is_inside = (material.index > 1) == (random.below(3) > 0);
    const double q = is_inside ? double{material.index} : 1 / double{material.index};
    double sine = random_sine(random, 0.97F);
    const std::uint32_t kind = q > 1.05 ? random.below(11) : 10;
    const double near = std::pow(10.0, random.uniform(-3, -1.7F));
    if (kind < 4) sine = (1 - near) / q;
    if (kind == 4) sine = (1 + near) / q;
    if (kind > 4 && kind < 10) sine = std::min(0.98, (1.05 + 0.3 * random.uniform_double()) / q);
    if (std::abs(q * sine - 1) < 9e-4) sine *= 0.9;
    const glm::vec3 v = random.unit_vector();
    const glm::vec3 normal = tilted(v, sine, random);
    const float t = std::exp2(random.uniform(-5, 10));
    Look look{{}, {t, random.in_cube(), is_inside ? -normal : normal, {0, 0}, material}, v};
    add_lights(look.world, lights, random);
    set_levels(look, random);
    return look;
}

/// The mirror with something far off that is seen in it, where there is no light; and the glass with something far off
/// behind it.
inline Look mirror_of_the_far_off(Random& random, std::uint32_t lights)
{
    Look look = mirror(random, lights);
    if (lights == 0) add_far_off(look, glm::reflect(-look.v, look.hit.normal), 0.3F, random);
    return look;
}
inline Look glass_before_the_far_off(Random& random, std::uint32_t lights)
{
    Look look = interface_of_glass(random, lights);
    if (lights == 0) add_far_off(look, -look.v, 0.6F, random);
    return look;
}

/// Balls and panels of all materials.
inline BuiltWorld random_world(Random& random)
{
    BuiltWorld world;
    const auto material = [&] {
        Material any = matt(random);
        any.texture = random.below(3);
        const std::uint32_t kind = random.below(4);
        if (kind == 1 || kind == 3) any.mirrored = random.uniform(0.2F, 0.8F);
        if (kind >= 2) any.refracted = random.uniform(0.2F, 0.9F);
        any.mirrored_color = random_color(random);
        any.refracted_color = random_color(random);
        any.index = random.uniform(1.1F, 1.8F);
        return any;
    };
    for (int i = 0; i < 5; ++i) world.balls.push_back({2.5F * random.in_cube(), random.uniform(0.4F, 1), material()});
    world.balls.front().relief = 0.1F;
    for (int i = 0; i < 2; ++i) {
        const glm::vec3 u = 5.0F * random.unit_vector();
        const glm::vec3 v(4.0 * perpendicular_to(normalize(glm::dvec3(u)), random));
        world.panels.push_back({2.5F * random.unit_vector() - 0.5F * (u + v), u, v, material()});
    }
    for (std::uint32_t i = 0; i < 2; ++i) world.sources.push_back(random_light(random, 9));
    world.global = random_color(random, 0.2F);
    world.levels = 3 + static_cast<int>(random.below(3));
    return world;
}

}
