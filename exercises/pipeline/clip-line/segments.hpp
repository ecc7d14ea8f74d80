#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <umbral/pipeline/clip_line.hpp>
#include <vector>

#include "../support.hpp"

/// Segments that are drawn for a window: some that meet it, some that miss it, on both sides of what is hard.
namespace umbral::pipeline {

struct Task {
    ClipWindow window;
    LineSegment segment;
    float unit = 1;  ///< what coordinates are multiplied by for the unit, and divided by afterwards; a power of two
};

// What the unit is asked.
inline Task in_unit(const Task& task)
{
    const auto& [window, segment, unit] = task;
    return {{unit * window.low, unit * window.high}, {unit * segment.from, unit * segment.to}};
}

inline void add_pair(std::vector<Task>& tasks, const Task& one, const Task& other, Random& random)
{
    const bool swapped = random.below(2) == 0;
    tasks.push_back(swapped ? other : one);
    tasks.push_back(swapped ? one : other);
}

inline ClipWindow random_window(Random& random)
{
    const glm::vec2 middle(random.in_cube());
    return {middle - random.uniform(0.25F, 1), middle + random.uniform(0.25F, 1)};
}

// One time in four along an axis.
inline glm::vec2 direction(Random& random)
{
    const std::uint32_t axis = random.below(16);
    const float turn = random.uniform(0, 6.2831853F);
    if (axis < 4) return (axis % 2 == 0 ? 1.0F : -1.0F) * (axis < 2 ? glm::vec2(1, 0) : glm::vec2(0, 1));
    return {std::cos(turn), std::sin(turn)};
}

// A segment through the inner part of the window, and one with no point in it that no code rejects at once, as long as
// `reach` windows or less, in a unit from 2^smallest to 2^largest.
inline void add_random_pair(std::vector<Task>& tasks, Random& random, float reach, int smallest, int largest)
{
    const ClipWindow window = random_window(random);
    const glm::vec2 half = 0.5F * (window.high - window.low);
    const glm::vec2 middle = window.low + half;
    const glm::vec2 through = middle + 0.8F * half * glm::vec2(random.in_cube());
    const glm::vec2 along = direction(random);
    const float back = random.below(3) == 0 ? 0 : reach * random.uniform();
    LineSegment hit{through - back * along, through + reach * random.uniform() * along};
    // Sometimes a point, in the window or on its border.
    const std::uint32_t place = random.below(40);
    const glm::vec2 border(place % 2 == 0 ? window.low.x : window.high.x, through.y);
    if (place < 3) hit = place < 2 ? LineSegment{border, border} : LineSegment{through, through};

    const glm::vec2 quadrant(random.below(2) == 0 ? 1 : -1, random.below(2) == 0 ? 1 : -1);
    const glm::vec2 past = middle + random.uniform(1.15F, 1.6F) * half * quadrant;
    const float steepness = random.uniform(0.1F, 0.9F);
    const glm::vec2 aside = quadrant * glm::vec2(steepness, steepness - 1);
    const float before = reach * random.uniform(0.2F, 1);
    const LineSegment miss{past - before * aside, past + reach * random.uniform(0.2F, 1) * aside};
    const bool turned = random.below(2) == 0;
    const float unit = random_unit(random, smallest, largest);
    add_pair(tasks, {window, hit, unit}, {window, turned ? LineSegment{miss.to, miss.from} : miss, unit}, random);
}

inline std::vector<Task> random_pairs(Random& random, int count, float reach, int smallest = -26, int largest = 12)
{
    std::vector<Task> tasks;
    for (int i = 0; i < count; ++i) add_random_pair(tasks, random, reach, smallest, largest);
    return tasks;
}

// Segments as long as a thousand windows that pass a corner on this side of it or on that one, by less than a
// ten-thousandth of a pixel.
inline std::vector<Task> corner_pairs(Random& random, int count)
{
    std::vector<Task> tasks;
    const ClipWindow window{{-320, -240}, {320, 240}};
    for (int i = 0; i < count; ++i) {
        const glm::i64vec2 quadrant(random.below(2) == 0 ? 1 : -1, random.below(2) == 0 ? 1 : -1);
        const glm::i64vec2 corner = quadrant * glm::i64vec2(320, 240);
        // Coprime, so that there is a whole vector beside it; from the outside of one border towards the outside of the
        // other one.
        glm::i64vec2 u(20'000 + random.below(400'000), 20'000 + random.below(400'000));
        while (std::gcd(u.x, u.y) != 1) ++u.y;
        u *= quadrant * glm::i64vec2(1, -1);
        const std::int64_t k = 1 + random.below(3);
        // The corner lies to one side of the line if the whole vector turns to the other. Inside is towards the middle,
        // at -quadrant.
        const std::int64_t inwards = quadrant.x * quadrant.y > 0 ? -k : k;
        const bool turned = random.below(2) == 0;
        const auto task = [&](std::int64_t turn) {
            const LineSegment segment{glm::vec2(corner - u), glm::vec2(corner + nearly_along(u, turn))};
            return Task{window, turned ? LineSegment{segment.to, segment.from} : segment};
        };
        add_pair(tasks, task(inwards), task(-inwards), random);
    }
    return tasks;
}

// Lines that pass a corner at the origin on either side, by 2^-22 to 2^-45 of the window: one end is so near, and the
// other one as far away as the window is wide. No rounding hides how near: beside 0 floats are fine.
inline std::vector<Task> origin_pairs(Random& random, int count)
{
    std::vector<Task> tasks;
    for (int i = 0; i < count; ++i) {
        const glm::vec2 quadrant(random.below(2) == 0 ? 1 : -1, random.below(2) == 0 ? 1 : -1);
        const glm::vec2 far_corner = quadrant * glm::vec2(random.uniform(0.5F, 2), random.uniform(0.5F, 2));
        const ClipWindow window{glm::min(glm::vec2(0), far_corner), glm::max(glm::vec2(0), far_corner)};
        const float width = random.uniform(0.25F, 1);
        const float height = random.uniform(0.25F, 1);
        const float nearness = random_unit(random, -18, 0);
        const float steps = static_cast<float>(1 + random.below(3));
        const bool turned = random.below(2) == 0;
        const bool from_below = random.below(2) == 0;
        const float unit = random_unit(random, -40, 40);
        const auto task = [&](float turn) {
            const float moved = height + turn * steps * 0x1p-24F;
            glm::vec2 near_end = nearness * glm::vec2(-width, moved);
            glm::vec2 far_end = glm::vec2(width, -height);
            if (from_below) {
                near_end = {near_end.y, near_end.x};
                far_end = {far_end.y, far_end.x};
            }
            const LineSegment segment{quadrant * near_end, quadrant * far_end};
            return Task{window, turned ? LineSegment{segment.to, segment.from} : segment, unit};
        };
        add_pair(tasks, task(1), task(-1), random);
    }
    return tasks;
}

// One end, or one time in four both, outside by a hair: by a few ulps or, of a border at 0, by 2^-24 to 2^-40.
inline std::vector<Task> hair_outside(Random& random, int count)
{
    std::vector<Task> tasks;
    for (int i = 0; i < count; ++i) {
        ClipWindow window = random_window(random);
        const int axis = static_cast<int>(random.below(2));
        const bool is_high = random.below(2) == 0;
        const float outwards = is_high ? 1 : -1;
        const bool at_zero = random.below(2) == 0;
        float& border = is_high ? window.high[axis] : window.low[axis];
        float& opposite = is_high ? window.low[axis] : window.high[axis];
        if (at_zero) {
            opposite -= border;
            border = 0;
        }
        const auto outside = [&] {
            float place = border;
            if (at_zero) place = outwards * std::exp2(random.uniform(-40, -24));
            for (std::uint32_t ulps = at_zero ? 0 : 1 + random.below(3); ulps > 0; --ulps)
                place = std::nextafter(place, outwards * std::numeric_limits<float>::infinity());
            return place;
        };
        const glm::vec2 half = 0.5F * (window.high - window.low);
        const auto somewhere = [&] { return window.low + half + 0.8F * half * glm::vec2(random.in_cube()); };
        LineSegment segment{somewhere(), somewhere()};
        segment.from[axis] = outside();
        if (i % 4 == 0) segment.to[axis] = outside();
        if (i % 4 == 1) segment.to += 3.0F * (segment.to - segment.from);
        if (random.below(2) == 0) std::swap(segment.from, segment.to);
        tasks.push_back({window, segment, random_unit(random, -26, 12)});
    }
    return tasks;
}

// Every sixth pair is moved to where the largest of its numbers is as large as a float can be, up to a factor of two: a
// float holds neither sums nor differences of these.
inline std::vector<Task> some_huge(std::vector<Task> pairs)
{
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 12) {
        float largest = 0;
        for (const std::size_t task : {i, i + 1}) {
            const auto& [window, segment, unit] = pairs[task];
            for (const glm::vec2& point : {window.low, window.high, segment.from, segment.to})
                largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
        }
        for (const std::size_t task : {i, i + 1}) pairs[task].unit = std::ldexp(1.0F, 127 - std::ilogb(largest));
    }
    return pairs;
}

}
