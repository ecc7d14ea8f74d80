#pragma once

#include <algorithm>
#include <cmath>
#include <kit/magnitude.hpp>
#include <umbral/core/random.hpp>
#include <umbral/raytracing/shadow_polygons.hpp>
#include <vector>

/// Polygons, lights and mirrors for raytracing/shadow-polygons.
namespace umbral::raytracing {

/// One question put to shadow_polygon.
struct ShadowTask {
    glm::vec4 light;
    FlatPolygon caster;
    FlatPolygon receiver;
    float unit = 1;  ///< what lengths are multiplied by for the unit, and divided by afterwards; a power of two
};

inline FlatPolygon times(FlatPolygon polygon, float factor)
{
    for (glm::vec3& corner : polygon) corner *= factor;
    return polygon;
}

/// A lamp's place; the length of a sun's direction means nothing, and stays.
inline glm::vec4 times(const glm::vec4& light, float factor)
{
    return light.w == 0 ? light : glm::vec4(factor * glm::vec3(light), 1);
}

/// Two unit vectors that make a right-handed frame with the unit vector `normal`.
struct PlaneFrame {
    glm::vec3 u;
    glm::vec3 v;
};

inline PlaneFrame frame_of(const glm::vec3& normal, float turn = 0)
{
    const glm::vec3 other = std::abs(normal.x) < 0.7F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 a = normalize(cross(other, normal));
    const glm::vec3 b = cross(normal, a);
    return {std::cos(turn) * a + std::sin(turn) * b, std::cos(turn) * b - std::sin(turn) * a};
}

/// Counter-clockwise as seen from where `normal` points to: corners on a circle, at angles that are not alike.
inline FlatPolygon random_convex(Random& random, const glm::vec3& middle, const glm::vec3& normal, float radius,
                                 std::uint32_t corners)
{
    const PlaneFrame frame = frame_of(normal, random.uniform(0, 6.28F));
    FlatPolygon polygon;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const float share = (static_cast<float>(i) + random.uniform(-0.3F, 0.3F)) / static_cast<float>(corners);
        const float angle = share * 6.2831853F;
        polygon.push_back(middle + radius * (std::cos(angle) * frame.u + std::sin(angle) * frame.v));
    }
    return polygon;
}

/// A rectangle of these sides, counter-clockwise as seen from along x up.
inline FlatPolygon rectangle(const glm::vec3& corner, const glm::vec3& along, const glm::vec3& up)
{
    return {corner, corner + along, corner + along + up, corner + up};
}

inline FlatPolygon turned_over(FlatPolygon polygon)
{
    std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

/// A receiver anywhere, a light on either side, and a caster whose shadow falls on the receiver, in part or as a whole.
/// Every third one reaches through the receiver's plane, and every fifth one past the light; every fourth one has many
/// corners, or its receiver.
inline ShadowTask random_shadow(Random& random, int kind)
{
    const glm::vec3 middle = 2.0F * random.in_cube();
    const glm::vec3 normal = random.unit_vector();
    const float size = random.uniform(0.8F, 1.6F);
    ShadowTask task;
    task.receiver = random_convex(random, middle, normal, size, 3 + random.below(kind % 4 == 1 ? 22 : 4));
    const float side = random.below(2) == 0 ? 1.0F : -1.0F;
    const PlaneFrame frame = frame_of(normal);
    const float height = random.uniform(2, 4);
    const glm::vec3 away = side * height * normal + random.uniform(-2, 2) * frame.u + random.uniform(-2, 2) * frame.v;
    const bool is_sun = random.below(2) == 0;
    task.light = is_sun ? glm::vec4(random.uniform(0.3F, 2) * random_unit(random, -30, 30) * away, 0)
                        : glm::vec4(middle + away, 1);
    const float share = kind % 5 == 4 && !is_sun ? 0.8F : kind % 3 == 2 ? 0.1F : random.uniform(0.25F, 0.55F);
    const glm::vec3 target = middle + 0.6F * size * (random.uniform(-1, 1) * frame.u + random.uniform(-1, 1) * frame.v);
    const glm::vec3 place = target + share * (middle + away - target);
    glm::vec3 tilt = normal + 0.6F * random.in_cube();
    if (share == 0.8F || share == 0.1F) tilt = frame.u + 0.5F * random.in_cube();
    const float reach = share == 0.8F ? 1.3F : 0.8F;
    task.caster = random_convex(random, place, normalize(tilt), reach,
                                kind % 4 == 3 ? 13 + random.below(12) : 3 + random.below(4));
    if (random.below(2) == 0) task.caster = turned_over(task.caster);
    task.unit = random_unit(random, -20, 20);
    return task;
}

/// The same, as small as it is far away: coordinates in the thousands, a light in the millions.
inline ShadowTask far_shadow(Random& random)
{
    ShadowTask task = random_shadow(random, 0);
    task.unit = 1;
    const glm::vec3 move = random.uniform(1000, 4000) * random.unit_vector();
    const float away = std::exp2(random.uniform(12, 20));
    for (FlatPolygon* polygon : {&task.caster, &task.receiver})
        for (glm::vec3& corner : *polygon) corner += move;
    if (task.light.w != 0) {
        const glm::vec3 middle = 0.5F * (task.receiver[0] + task.receiver[2]);
        const glm::vec3 lifted = task.caster[0] + 0.5F * (task.caster[2] - task.caster[0]);
        task.light = glm::vec4(middle + away * (lifted - middle), 1);
    }
    return task;
}

/// A plane up to 4 from the origin; its normal has any length. One in four is so long or short that its square is none
/// of a float's numbers.
inline glm::vec4 random_plane(Random& random, int kind)
{
    const glm::vec3 normal = random.unit_vector();
    const float away = random.uniform(-4, 4);
    const float far = std::exp2(static_cast<float>(80 + random.below(35)));
    const float unit = kind % 4 != 3 ? random_unit(random, -30, 30) : kind % 8 == 3 ? far : 1 / far;
    return random.uniform(0.3F, 3) * unit * glm::vec4(normal, away);
}

/// One question put to mirror_views.
struct MirrorTask {
    glm::vec3 eye;
    std::vector<FlatPolygon> mirrors;
    int levels;
    float unit = 1;  ///< as of ShadowTask
};

/// A few mirrors round the eye, most of them turned towards it.
inline MirrorTask random_mirrors(Random& random, std::size_t count, int levels)
{
    MirrorTask task{0.3F * random.in_cube(), {}, levels, random_unit(random, -20, 20)};
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 middle = random.uniform(1.5F, 2.5F) * random.unit_vector();
        const glm::vec3 normal = normalize(-middle + 0.5F * random.in_cube());
        task.mirrors.push_back(
            random_convex(random, middle, i == 1 ? -normal : normal, random.uniform(0.8F, 1.8F), 3 + random.below(3)));
    }
    return task;
}

}
