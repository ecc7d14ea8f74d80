#include <kit/varied.hpp>
#include <limits>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "chords.hpp"
#include "segments.hpp"
#include "special.hpp"

namespace umbral {
namespace {

using namespace pipeline;

// Both ends of what is left.
std::optional<glm::vec4> ends(Recorder& out, const Task& task)
{
    const Task asked = in_unit(task);
    const std::optional<LineSegment> left = ask<clip_segment>(out, asked.window, asked.segment);
    if (!left) return std::nullopt;
    return glm::vec4(left->from / task.unit, left->to / task.unit);
}

void record(Recorder& out, const std::vector<Task>& tasks)
{
    out.columns("ends", "from.x, from.y, to.x, to.y");
    for (const Task& task : tasks) out.append("ends", ends(out, task));
}

/// Tasks that are written down, mirrored or turned, in a unit of their own, in another order.
std::vector<Task> varied(Variation& vary, std::vector<Task> tasks)
{
    const PlaneMap map = plane_map(vary);
    for (auto& [window, segment, unit] : tasks) {
        const glm::vec2 one = map.place(window.low);
        const glm::vec2 other = map.place(window.high);
        window = {glm::min(one, other), glm::max(one, other)};
        segment = {map.place(segment.from), map.place(segment.to)};
        unit = other_unit(vary, 8);
    }
    return in_random_order(vary, std::move(tasks));
}

// All nine regions, the borders between them, and places one ulp beside those. Two windows are as large as floats are,
// so that no float holds the sum of their borders.
void record_codes(Variation& vary, Recorder& out)
{
    for (ClipWindow window : {ClipWindow{{-1, -1}, {1, 1}},
                              {{0, 2}, {4, 3}},
                              {{100, -7}, {101, -5}},
                              {{-3e38F, 1.75e38F}, {-2e38F, 2.5e38F}},
                              {{1.8e38F, -3.2e38F}, {2.75e38F, -1.75e38F}}}) {
        const float size = window.high.y < 1e30F && window.low.y > -1e30F ? 1.0F : vary.near(1.0F, 0.05F);
        window = {size * window.low, size * window.high};
        const glm::vec2 shift = vary.near(glm::vec2(0), 3.0F);
        window = {window.low + shift, window.high + shift};
        const auto places = [](float low, float high) {
            const float infinity = std::numeric_limits<float>::infinity();
            return std::array{low - 1,
                              std::nextafter(low, -infinity),
                              low,
                              std::nextafter(low, infinity),
                              0.5F * low + 0.5F * high,
                              std::nextafter(high, -infinity),
                              high,
                              std::nextafter(high, infinity),
                              high + 5};
        };
        std::vector<glm::vec2> points;
        for (const float y : places(window.low.y, window.high.y))
            for (const float x : places(window.low.x, window.high.x)) points.emplace_back(x, y);
        for (const glm::vec2& point : in_random_order(vary, points))
            out.append("codes", std::uint32_t{ask<region_code>(out, window, point)});
    }
}

// A point in one window after the other: what was found in the last one says nothing.
void record_codes_in_turn(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const glm::vec2 point = 2.0F * glm::vec2(random.in_cube());
        for (int k = 0; k < 3; ++k)
            out.append("codes", std::uint32_t{ask<region_code>(out, random_window(random), point)});
    }
}

std::vector<Task> by_hand()
{
    const ClipWindow window{{0, 0}, {4, 2}};
    std::vector<Task> tasks;
    for (const auto& [from, to] : {LineSegment{{1, 1}, {3, 1.5F}},  // inside
                                   {{-2, 1}, {2, 1}},               // into it
                                   {{1, 1}, {1, 5}},                // out of it
                                   {{-4, -1}, {8, 3.5F}},           // through
                                   {{-1, 3}, {5, 3}},               // above
                                   {{-1, 1}, {1, 4}},               // past a corner: no common side, yet outside
                                   {{-1, 1}, {3, 3}},               // … over the corner's side
                                   {{5, 2}, {3, -2}},               // through a corner region, right to below
                                   {{6, 4}, {-2, -2}},              // from corner region to corner region
                                   {{-2, 4}, {6, -2}},
                                   {{6, -1}, {5, 5}},         // right of it
                                   {{3, 7}, {2, -6}},         // from above to below
                                   {{-3, 2.5F}, {2.5F, -3}},  // past the lower left corner
                                   {{7, 1.5F}, {-5, 0.5F}}})
        tasks.push_back({window, {from, to}});
    return tasks;
}

// Segments on borders, in corners, without length, along the axes, and nonsense.
std::vector<Task> borders()
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const ClipWindow window{{-1, -1}, {1, 1}};
    const float beside = std::nextafter(1.0F, 2.0F);
    std::vector<Task> tasks;
    for (const auto& [from, to] : {LineSegment{{-3, 1}, {3, 1}},    // on the upper border
                                   {{-3, beside}, {3, beside}},     // one ulp above it
                                   {{-1, 3}, {-1, -0.5F}},          // on the left one
                                   {{1, 0}, {3, 0.5F}},             // begins on the right one
                                   {{0, 2}, {2, 0}},                // touches a corner
                                   {{0, 2.5F}, {2, 0.5F}},          // … misses it
                                   {{-2, 0}, {0, -2}},              // touches another one
                                   {{-2, -2}, {2, 2}},              // through two corners
                                   {{0.5F, 0.25F}, {0.5F, 0.25F}},  // a point inside
                                   {{1, 1}, {1, 1}},                // … in a corner
                                   {{2, 0}, {2, 0}},                // … outside
                                   {{0.5F, -4}, {0.5F, 4}},         // vertical
                                   {{4, 0.25F}, {-4, 0.25F}},       // horizontal
                                   {{1.5F, -4}, {1.5F, 4}},         // vertical, outside
                                   {{1, 1}, {2, 2}},                // leaves from a corner
                                   {{beside, 5}, {1, -5}},          // nearly along a border
                                   {{nan, 0}, {0, 0}},
                                   {{0, 0}, {0.5F, nan}},
                                   {{-infinity, 0}, {0, 0}}})
        tasks.push_back({window, {from, to}});
    tasks.push_back({{{2, 2}, {2, 2}}, {{0, 0}, {4, 4}}});  // a window that is a point
    tasks.push_back({{{2, 0}, {2, 5}}, {{0, 1}, {4, 3}}});  // … a line
    return tasks;
}

// On which borders of the window a point lies exactly, as bits: those of region_code.
float borders_at(const ClipWindow& window, const glm::vec2& point)
{
    const int across = (point.x == window.low.x ? 1 : 0) + (point.x == window.high.x ? 2 : 0);
    return static_cast<float>(across + (point.y == window.low.y ? 4 : 0) + (point.y == window.high.y ? 8 : 0));
}

// Each segment and its reverse: which of the four ends is the first one with the same bits, and on which borders they
// lie.
void record_both_ways(Random& random, Recorder& out)
{
    std::vector<Task> tasks = random_pairs(random, 200, 6);
    for (const Task& task : hair_outside(random, 120)) tasks.push_back(task);
    out.columns("first", "the first end with its bits (0: there.from; 1: there.to; 2: back.from; 3: back.to)");
    out.columns("border",
                "the borders that it lies on (0: none; 1: left; 2: right; 4: below; 5: left and below; 6: right and "
                "below; 8: above; 9: left and above; 10: right and above)");
    for (const Task& task : tasks) {
        const auto& [window, segment, unit] = in_unit(task);
        const LineSegment reversed{segment.to, segment.from};
        ask_in_words(out, [&] {
            const auto call = [&](const LineSegment& one) {
                return "clip_segment(" + literal::of_value(window, true, {}) + ", " + literal::of_value(one, true, {}) +
                       ");";
            };
            return "const auto there = " + call(segment) + "\nconst auto back = " + call(reversed);
        });
        // The window that the borders are looked up in is not the one that the unit got.
        const std::optional<LineSegment> there = clip_segment(ClipWindow(window), segment);
        const std::optional<LineSegment> back = clip_segment(ClipWindow(window), reversed);
        const bool both = there && back;
        const std::array four =
            both ? std::array{there->from, there->to, back->from, back->to} : std::array<glm::vec2, 4>{};
        for (const glm::vec2& end : four) {
            const auto first = static_cast<float>(std::find(four.begin(), four.end(), end) - four.begin());
            out.append("first", both ? std::optional(first) : std::nullopt);
            out.append("border", both ? std::optional(borders_at(window, end)) : std::nullopt);
        }
    }
}

}

const Driver driver = {
    {"codes",
     [](Case& c, Recorder& out) {
         record_codes(c.vary, out);
         record_codes_in_turn(c.random, out);
     }},
    {"by hand", [](Case& c, Recorder& out) { record(out, varied(c.vary, by_hand())); }},
    {"borders", [](Case& c, Recorder& out) { record(out, varied(c.vary, borders())); }},
    {"random", [](Case& c, Recorder& out) { record(out, random_pairs(c.random, 400, 6)); }},
    {"thin", [](Case& c, Recorder& out) { record(out, thin_pairs(c.random, 160)); }},
    {"nonsense", [](Case& c, Recorder& out) { record(out, nonsense_pairs(c.random)); }},
    {"both ways", [](Case& c, Recorder& out) { record_both_ways(c.random, out); }},
    {"long", [](Case& c, Recorder& out) { record(out, some_huge(random_pairs(c.random, 300, 5e5F, -90, 90))); }},
    {"huge", [](Case& c, Recorder& out) { record(out, huge_pairs(c.random, 100)); }},
    {"corners",
     [](Case& c, Recorder& out) {
         record(out, corner_pairs(c.random, 300));
         record(out, origin_pairs(c.random, 100));
     }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_chords(out, c.vary)); }},
};

}
