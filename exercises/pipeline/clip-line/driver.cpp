#include <bit>
#include <kit/varied.hpp>
#include <limits>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "chords.hpp"

namespace umbral {
namespace {

using namespace pipeline;

struct Task {
    ClipWindow window;
    LineSegment segment;
    float unit = 1;  ///< what coordinates are multiplied by for the unit, and divided by afterwards; a power of two
};

// What the unit is asked.
Task in_unit(const Task& task)
{
    const auto& [window, segment, unit] = task;
    return {{unit * window.low, unit * window.high}, {unit * segment.from, unit * segment.to}};
}

// The four numbers of what is left, or four times nothing.
std::array<std::optional<float>, 4> ends(Recorder& out, const Task& task)
{
    const Task asked = in_unit(task);
    const std::optional<LineSegment> left = ask<clip_segment>(out, asked.window, asked.segment);
    if (!left) return {};
    const glm::vec2 from = left->from / task.unit;
    const glm::vec2 to = left->to / task.unit;
    return {from.x, from.y, to.x, to.y};
}

void record(Recorder& out, const std::vector<Task>& tasks)
{
    for (const Task& task : tasks)
        for (const std::optional<float>& number : ends(out, task)) out.append("ends", number);
}

// Tasks 2k and 2k + 1 are a pair: each number of one stands beside that of the other, so that each is asked for alone.
void record_pairs(Recorder& out, const std::vector<Task>& tasks)
{
    for (std::size_t i = 0; i + 1 < tasks.size(); i += 2)
        for (std::size_t k = 0; k < 4; ++k)
            for (const std::size_t task : {i, i + 1}) out.append("ends", ends(out, tasks[task])[k]);
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

void add_pair(std::vector<Task>& tasks, const Task& one, const Task& other, Random& random)
{
    const bool swapped = random.below(2) == 0;
    tasks.push_back(swapped ? other : one);
    tasks.push_back(swapped ? one : other);
}

// All nine regions, the borders between them, and places one ulp beside those.
void record_codes(Variation& vary, Recorder& out)
{
    for (ClipWindow window : {ClipWindow{{-1, -1}, {1, 1}}, {{0, 2}, {4, 3}}, {{100, -7}, {101, -5}}}) {
        const glm::vec2 shift = vary.near(glm::vec2(0), 3.0F);
        window = {window.low + shift, window.high + shift};
        const auto places = [](float low, float high) {
            const float infinity = std::numeric_limits<float>::infinity();
            return std::array{low - 1,
                              std::nextafter(low, -infinity),
                              low,
                              std::nextafter(low, infinity),
                              0.5F * (low + high),
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

ClipWindow random_window(Random& random)
{
    const glm::vec2 middle(random.in_cube());
    return {middle - random.uniform(0.25F, 1), middle + random.uniform(0.25F, 1)};
}

// One time in four along an axis.
glm::vec2 direction(Random& random)
{
    const std::uint32_t axis = random.below(16);
    const float turn = random.uniform(0, 6.2831853F);
    if (axis < 4) return (axis % 2 == 0 ? 1.0F : -1.0F) * (axis < 2 ? glm::vec2(1, 0) : glm::vec2(0, 1));
    return {std::cos(turn), std::sin(turn)};
}

// A segment through the inner part of the window, and one with no point in it that no code rejects at once, as long as
// `reach` windows or less, in a unit from 2^smallest to 2^largest.
void add_random_pair(std::vector<Task>& tasks, Random& random, float reach, int smallest, int largest)
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

std::vector<Task> random_pairs(Random& random, int count, float reach, int smallest = -26, int largest = 12)
{
    std::vector<Task> tasks;
    for (int i = 0; i < count; ++i) add_random_pair(tasks, random, reach, smallest, largest);
    return tasks;
}

// Segments as long as a thousand windows that pass a corner on this side of it or on that one, by less than a
// ten-thousandth of a pixel.
std::vector<Task> corner_pairs(Random& random, int count)
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
        const auto task = [&](std::int64_t turn) {
            return Task{window, {glm::vec2(corner - u), glm::vec2(corner + nearly_along(u, turn))}};
        };
        add_pair(tasks, task(inwards), task(-inwards), random);
    }
    return tasks;
}

// Each segment and its reverse: which of the four ends is the first one with the same bits.
void record_both_ways(Random& random, Recorder& out)
{
    const std::vector<Task> tasks = random_pairs(random, 200, 6);
    out.text("first.names", "segment: end, -");
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        const auto& [window, segment, unit] = in_unit(tasks[i]);
        const LineSegment reversed{segment.to, segment.from};
        ask_in_words(out, [&] {
            const auto call = [&](const LineSegment& one) {
                return "clip_segment(" + literal::of_value(window, true, {}) + ", " + literal::of_value(one, true, {}) +
                       ");";
            };
            return "const auto there = " + call(segment) + "\nconst auto back = " + call(reversed);
        });
        const std::optional<LineSegment> there = clip_segment(window, segment);
        const std::optional<LineSegment> back = clip_segment(window, reversed);
        if (!there || !back) continue;
        const std::array four = {there->from, there->to, back->from, back->to};
        for (std::size_t k = 0; k < four.size(); ++k) {
            const auto first = std::find(four.begin(), four.end(), four[k]) - four.begin();
            out.append("first", std::span<const float>(std::array{static_cast<float>(i), static_cast<float>(k), 0.0F,
                                                                  static_cast<float>(first)}));
        }
    }
}

}

const Driver driver = {
    {"codes", [](Case& c, Recorder& out) { record_codes(c.vary, out); }},
    {"by hand", [](Case& c, Recorder& out) { record(out, varied(c.vary, by_hand())); }},
    {"borders", [](Case& c, Recorder& out) { record(out, varied(c.vary, borders())); }},
    {"random", [](Case& c, Recorder& out) { record_pairs(out, random_pairs(c.random, 400, 6)); }},
    {"both ways", [](Case& c, Recorder& out) { record_both_ways(c.random, out); }},
    {"long", [](Case& c, Recorder& out) { record_pairs(out, random_pairs(c.random, 300, 5e5F, -90, 90)); }},
    {"corners", [](Case& c, Recorder& out) { record_pairs(out, corner_pairs(c.random, 300)); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_chords(out, c.vary)); }},
};

}
