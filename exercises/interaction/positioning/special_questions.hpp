#pragma once

#include <cmath>
#include <kit/numbers_changed.hpp>
#include <umbral/interaction/positioning.hpp>
#include <umbral/record/ask.hpp>

#include "snap_cameras.hpp"

/// Limits, moves and planes: random ones, and such as random ones are not.
namespace umbral::interaction {

/// Limits of thousands, as of a map in metres, that put the pixel near the origin.
inline ViewLimits map_limits(glm::ivec2 pixel, glm::ivec2 size, Random& random)
{
    const double width = between(3e3, 1e4, random);
    const double height = between(3e3, 1e4, random);
    const double left = between(-20.0, 20.0, random) - width * (pixel.x + 0.5) / size.x;
    const double top = between(-20.0, 20.0, random) + height * (pixel.y + 0.5) / size.y;
    return {left, left + width, top - height, top};
}

/// One in four is mirrored, in each direction on its own.
inline ViewLimits random_limits(Random& random)
{
    const auto length = [&] {
        const double unsigned_length = between(0.5, 30.0, random);
        return random.below(4) == 0 ? -unsigned_length : unsigned_length;
    };
    const double left = between(-20.0, 20.0, random);
    const double bottom = between(-20.0, 20.0, random);
    const double width = length();
    return {left, left + width, bottom, bottom + length()};
}

/// A limit of 0, equal ones of both directions, and questions that differ in a single number from the one before.
inline void record_changed_linear(Recorder& out, Random& random)
{
    const auto is_wide = [](const glm::vec4& l) { return std::abs(l.x - l.y) > 0.4F && std::abs(l.z - l.w) > 0.4F; };
    for (int i = 0; i < 12; ++i) {
        glm::ivec2 size(between(1, 300, random), between(1, 300, random));
        glm::ivec2 pixel(between(0, size.x - 1, random), between(0, size.y - 1, random));
        ViewLimits limits;
        const auto record = [&] { out.append("world", ask<pixel_in_world>(out, pixel, limits, size)); };
        const ViewLimits first = random_limits(random);
        for (const glm::vec4& l :
             numbers_changed(random, glm::vec4(first.left, first.right, first.bottom, first.top), 3, is_wide)) {
            limits = {l.x, l.y, l.z, l.w};
            record();
        }
        for (const int axis : {0, 1}) {
            pixel[axis] = i % 3 == 0 ? 0 : pixel[axis] + between(1, 9, random);
            record();
            size[axis] += between(1, 9, random);
            record();
        }
        pixel = size;
        record();
    }
}

/// About the direction, without the coordinate that counts least in it, and one time in three without the next one.
inline glm::dvec3 along_axes(const glm::dvec3& direction, Random& random)
{
    glm::dvec3 result = glm::normalize(direction) + 0.25 * glm::dvec3(random.in_cube());
    for (int left = random.below(3) == 0 ? 2 : 1; left > 0; --left) {
        int least = result[0] == 0 ? 1 : 0;
        for (int axis = 0; axis < 3; ++axis)
            if (result[axis] != 0 && std::abs(direction[axis]) < std::abs(direction[least])) least = axis;
        result[least] = 0;
    }
    return result;
}

/// A mouse that moves along one axis only, a cursor on an axis, and questions that differ in one number from the one
/// before.
inline void record_changed_moves(Recorder& out, Random& random)
{
    struct Move {
        glm::vec3 cursor;
        glm::vec2 motion;
        glm::vec4 limits;
    };
    const auto is_wide = [](const Move& m) {
        return std::abs(m.limits.x - m.limits.y) > 0.4F && std::abs(m.limits.z - m.limits.w) > 0.4F;
    };
    for (int i = 0; i < 16; ++i) {
        const ViewLimits first = random_limits(random);
        const Move move{4.0F * random.in_cube(),
                        60.0F * glm::vec2(random.in_cube()),
                        {first.left, first.right, first.bottom, first.top}};
        glm::ivec2 size(between(50, 1500, random), between(50, 900, random));
        for (const auto& [cursor, motion, l] : numbers_changed(random, move, 6, is_wide)) {
            const auto record = [&](const glm::vec2& by, unsigned buttons) {
                out.append("cursor", glm::vec3(ask<moved_cursor>(out, glm::dvec3(cursor), glm::dvec2(by), buttons,
                                                                 ViewLimits{l.x, l.y, l.z, l.w}, size)));
            };
            for (const unsigned buttons : {1U, 2U + random.below(2)}) {
                record(motion, buttons);
                record({0, motion.y}, buttons);
            }
            size[i % 2] += between(1, 90, random);
            record({motion.x, 0}, 1U + random.below(2));
        }
    }
}

/// Coordinates that are 0 or equal, and one that is the only other one than before.
inline void record_changed_views(Recorder& out, Random& random)
{
    for (int i = 0; i < 16; ++i)
        for (const auto& [place, cursor] :
             numbers_changed(random, std::pair(glm::vec2(random.in_cube()), 4.0F * random.in_cube()), 5))
            for (const LinkedView view : {LinkedView::front, LinkedView::top, LinkedView::side}) {
                out.append("shown", ask<cursor_in_view>(out, view, glm::dvec3(cursor)));
                out.append("entered",
                           glm::vec3(ask<cursor_from_view>(out, view, glm::dvec2(place), glm::dvec3(cursor))));
            }
}

}
