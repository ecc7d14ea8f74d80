#pragma once

#include <kit/magnitude.hpp>
#include <kit/placement.hpp>

#include "stage.hpp"

/// Single points, and where they lie for a projector.
namespace umbral::texturing {

inline Projector random_projector(Random& random)
{
    const glm::vec3 position = 4.0F * random.in_cube();
    const glm::vec3 target = position + random.unit_vector();
    const float fovy = random.uniform(20, 100);
    Projector projector = projector_at(position, target, fovy, random.uniform(0.6F, 1.6F));
    projector.lamp = glm::vec3(0.6F) + 0.4F * random.in_cube();
    projector.ambient = glm::vec3(0.15F) + 0.1F * random.in_cube();
    return projector;
}

/// A point that the projector has at (x, y) of its picture, both in [-1, 1], and that far along its axis; behind it if
/// that is negative, where x and y are mirrored.
inline glm::vec3 at_picture(const Projector& projector, glm::vec2 place, float distance)
{
    const glm::mat4& p = projector.projection;
    const glm::vec3 eye((place.x + p[2][0]) * distance / p[0][0], (place.y + p[2][1]) * distance / p[1][1], -distance);
    return glm::vec3(inverse(projector.view) * glm::vec4(eye, 1));
}

/// The same point with lengths in another unit: its colour is the same.
inline Point in_unit(Point point, float unit)
{
    point.projector.position *= unit;
    point.place *= unit;
    for (glm::mat4* const matrix : {&point.projector.view, &point.model})
        (*matrix)[3] = glm::vec4(unit * glm::vec3((*matrix)[3]), 1);
    return point;
}

/// Of the axes of the world and their opposites that which is closest to a direction.
inline glm::vec3 axis_next_to(const glm::vec3& direction)
{
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(direction[i]) > std::abs(direction[axis])) axis = i;
    glm::vec3 result(0);
    result[axis] = direction[axis] < 0 ? -1.0F : 1.0F;
    return result;
}

/// In the beam, beside it, and behind the projector, 2 % from the beam's border at least, in any unit of length.
inline std::vector<Point> random_points(Random& random, int count)
{
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        Point point;
        point.projector = random_projector(random);
        const bool beside = random.below(4) == 0;
        glm::vec2 place = 0.98F * glm::vec2(random.in_cube());
        const float outside = random.uniform(1.02F, 2);
        if (beside) place[random.below(2) == 0 ? 0 : 1] = random.below(2) == 0 ? outside : -outside;
        const float distance = random.uniform(0.3F, 8) * (random.below(3) == 0 ? -1.0F : 1.0F);
        point.place = at_picture(point.projector, place, distance);
        point.normal =
            glm::normalize(random.unit_vector() + 1.3F * glm::normalize(point.projector.position - point.place));
        point.color = glm::vec3(0.6F) + 0.35F * random.in_cube();
        point.model = random_placement(random);
        // Now and then a light or a surface has none of a colour, or a surface faces along an axis.
        const int channel = i / 4 % 3;
        if (i % 4 == 0) point.color[channel] = 0;
        if (i % 8 == 1) point.projector.lamp[channel] = 0;
        if (i % 8 == 5) point.projector.ambient[channel] = 0;
        if (i % 8 == 2) point.normal = axis_next_to(point.projector.position - point.place);
        points.push_back(in_unit(point, random_unit(random, -10, 10)));
    }
    return points;
}

/// A number that a float has with few bits, so that sums of them are exact: sixteenths from 1/16 to 2.
inline float few_bits(Random& random) { return static_cast<float>(1 + random.below(32)) / 16; }

inline float any_sign(Random& random) { return random.below(2) == 0 ? 1.0F : -1.0F; }

/// A projector whose clip coordinates are x, y and -z from its place, without any rounding.
inline Projector exact_projector(Random& random)
{
    const glm::vec3 position(few_bits(random), few_bits(random), few_bits(random));
    Projector projector = projector_at(position, position + glm::vec3(0, 0, -1), 90);
    projector.projection = glm::frustum(-1.0F, 1.0F, -1.0F, 1.0F, 1.0F, 3.0F);
    projector.lamp = glm::vec3(1.3F) + 0.5F * random.in_cube();
    projector.ambient = glm::vec3(0.06F) + 0.03F * random.in_cube();
    return projector;
}

/// Where a quotient has no value, or a term vanishes, and on the beam's border; between them ordinary points. A tenth
/// of each kind.
inline std::vector<Point> edges(Random& random)
{
    std::vector<Point> points;
    for (int round = 0; round < 6; ++round) {
        const Projector projector = exact_projector(random);
        const auto add = [&](const glm::vec3& from_projector, const glm::vec3& normal) {
            const glm::vec3 color = glm::vec3(0.6F) + 0.35F * random.in_cube();
            points.push_back({projector, projector.position + from_projector, normal, color, glm::mat4(1)});
        };
        // In the beam, at that distance along its axis.
        const auto inside = [&](float distance) {
            return distance * glm::vec3(0.9F * glm::vec2(random.in_cube()), -1);
        };
        const glm::vec3 back(0, 0, 1);
        for (int twice = 0; twice < 2; ++twice) {
            const glm::vec3 ordinary = inside(few_bits(random));
            add(ordinary, back);
            add(-ordinary, -back);                                           // its mirror image behind the projector
            add({0, 0, 0}, random.unit_vector());                            // where the projector is
            add({any_sign(random) * few_bits(random), few_bits(random), 0},  // on the projector's plane: w = 0
                glm::vec3(0, -1, 0));
            add(inside(few_bits(random)), twice == 0 ? -back : glm::normalize(random.unit_vector() - 1.2F * back));
            const glm::vec3 grazed = inside(few_bits(random));
            const glm::vec3 along = glm::normalize(glm::cross(grazed, random.unit_vector()));
            add(grazed, glm::normalize(along - random.uniform(-0.06F, 0.06F) * glm::normalize(grazed)));
            add(inside(std::exp2(random.uniform(-14, -7))), back);         // nearer than its near plane
            add(inside(std::exp2(random.uniform(8, 14))), back);           // farther than its far plane
            add({any_sign(random) * 30 * few_bits(random), 0, -1}, back);  // beside the beam, far
            // On the border, and beyond it, 1/128 of its width or much less.
            const float distance = few_bits(random);
            const float beyond = 1 + std::exp2(-static_cast<float>(7 + random.below(6)));
            const float share = random.uniform(-0.9F, 0.9F);
            const int axis = static_cast<int>(random.below(2));
            for (const float factor : {1.0F, beyond}) {
                glm::vec3 place(distance * share, distance * share, -distance);
                place[axis] = any_sign(random) * distance * factor;
                add(place, back);
            }
        }
    }
    return points;
}

}
