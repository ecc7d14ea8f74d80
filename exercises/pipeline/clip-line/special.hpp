#pragma once

#include "segments.hpp"

/// Pairs of one kind each: windows without width or height, the largest floats, and numbers that are none.
namespace umbral::pipeline {

/// As large as floats are, up to a factor of two; for coordinates up to 8.
inline constexpr float huge_unit = 0x1p125F;

/// Half of them round the origin, where differences leave float's range, and half far to one side, where sums do.
inline std::vector<Task> huge_pairs(Random& random, int count)
{
    std::vector<Task> tasks;
    for (int i = 0; i < count; ++i) {
        add_random_pair(tasks, random, 1.2F, 0, 0);
        glm::vec2 aside(0);
        if (i % 2 == 0) aside = {random.below(2) == 0 ? 4 : -4, random.below(2) == 0 ? 4 : -4};
        for (std::size_t k = tasks.size() - 2; k < tasks.size(); ++k) {
            auto& [window, segment, unit] = tasks[k];
            window = {window.low + aside, window.high + aside};
            segment = {segment.from + aside, segment.to + aside};
            // Round the origin all coordinates are below 4.
            unit = i % 2 == 0 ? huge_unit : 2 * huge_unit;
        }
    }
    return tasks;
}

/// Windows that are upright or level lines: segments that cross them, or their line beyond their ends; one time in four
/// along the line, on it or beside it.
inline void add_line_pair(std::vector<Task>& tasks, Random& random)
{
    const int axis = static_cast<int>(random.below(2));  // the one in which the window has no width
    const glm::vec2 middle(random.in_cube());
    const float half = random.uniform(0.25F, 1);
    ClipWindow window{middle, middle};
    window.low[1 - axis] -= half;
    window.high[1 - axis] += half;
    const float signs[] = {random.below(2) == 0 ? 1.0F : -1.0F, random.below(2) == 0 ? 1.0F : -1.0F};
    glm::vec2 along(0);
    along[axis] = signs[0] * random.uniform(0.4F, 1);
    along[1 - axis] = signs[1] * random.uniform(0.4F, 1);
    const float before = random.uniform(1, 4);
    const float after = random.uniform(1, 4);
    const float hit_at = 0.8F * half * random.uniform(-1, 1);
    const float miss_at = half * random.uniform(1.15F, 1.6F) * (random.below(2) == 0 ? 1.0F : -1.0F);
    const bool is_along = random.below(4) == 0;
    const auto task = [&](bool hits) {
        glm::vec2 through = middle;
        through[1 - axis] += hits || is_along ? hit_at : miss_at;
        if (is_along && !hits) through[axis] += 0.25F * signs[0];
        glm::vec2 way = along;
        if (is_along) way[axis] = 0;
        return Task{window, {through - before * way, through + after * way}, 1};
    };
    add_pair(tasks, task(true), task(false), random);
}

/// Windows that are points: segments through them or beside them. All numbers are whole eighths, and the point divides
/// the segment in eighths, so that nothing is rounded, whichever formula is used.
inline void add_point_pair(std::vector<Task>& tasks, Random& random)
{
    const auto whole = [&](int most) {
        return static_cast<float>(static_cast<int>(random.below(static_cast<std::uint32_t>(2 * most + 1))) - most);
    };
    // One after the other: in which order a compiler takes the arguments of a call is not said.
    glm::vec2 point, step;
    for (int axis = 0; axis < 2; ++axis) {
        point[axis] = 0.125F * whole(16);
        step[axis] = 0.125F * whole(6);
    }
    if (step == glm::vec2(0)) step.x = 0.5F;
    const float before = static_cast<float>(1 + random.below(7));
    const glm::vec2 aside = 0.25F * glm::vec2(-step.y, step.x);
    const LineSegment hit{point - before * step, point + (8 - before) * step};
    add_pair(tasks, {{point, point}, hit}, {{point, point}, {hit.from + aside, hit.to + aside}}, random);
}

inline std::vector<Task> thin_pairs(Random& random, int count)
{
    std::vector<Task> tasks;
    for (int i = 0; i < count; ++i) {
        if (i % 4 == 3)
            add_point_pair(tasks, random);
        else
            add_line_pair(tasks, random);
    }
    return tasks;
}

/// Segments of which one number is NaN or infinite, each of the four as often, and the same without it, which have a
/// part inside the window.
inline std::vector<Task> nonsense_pairs(Random& random)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::vector<Task> tasks;
    for (int i = 0; i < 48; ++i) {
        const ClipWindow window = random_window(random);
        const glm::vec2 half = 0.5F * (window.high - window.low);
        const glm::vec2 through = window.low + half + 0.5F * half * glm::vec2(random.in_cube());
        const glm::vec2 along = direction(random);
        const LineSegment right{through - random.uniform(0, 2) * along, through + random.uniform(0, 2) * along};
        LineSegment wrong = right;
        const float value = i % 3 == 0 ? std::numeric_limits<float>::quiet_NaN() : i % 3 == 1 ? infinity : -infinity;
        (i % 8 < 4 ? wrong.from : wrong.to)[i / 2 % 2] = value;
        add_pair(tasks, {window, right}, {window, wrong}, random);
    }
    return tasks;
}

}
