#include <kit/canonical.hpp>
#include <kit/magnitude.hpp>
#include <kit/varied.hpp>
#include <limits>
#include <umbral/record/driver.hpp>

#include "shapes.hpp"

namespace umbral {
namespace {

using namespace pipeline;

struct Task {
    Polygon polygon;
    Polygon window;
    float unit = 1;  ///< what coordinates are multiplied by for the unit, and divided by afterwards; a power of two
};

Polygon times(Polygon polygon, float factor)
{
    for (glm::vec2& corner : polygon) corner *= factor;
    return polygon;
}

Polygon answer(Recorder& out, const Task& task)
{
    return times(clipped(out, times(task.polygon, task.unit), times(task.window, task.unit)), 1 / task.unit);
}

// Rows [polygon, corner, 0, x, y].
void record(Recorder& out, const std::vector<Task>& tasks)
{
    out.text("corners.names", "polygon: corner, -");
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        const Polygon left = from_extreme(answer(out, tasks[i]));
        for (std::size_t k = 0; k < left.size(); ++k)
            out.append("corners", std::span<const float>(std::array{static_cast<float>(i), static_cast<float>(k), 0.0F,
                                                                    left[k].x, left[k].y}));
    }
}

const Polygon square = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
const Polygon triangle = {{0, 0}, {8, 0}, {0, 8}};

Polygon reversed(Polygon polygon)
{
    std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

/// Tasks that are written down, mirrored or turned about a point, in a unit of their own, in another order. Windows
/// stay counter-clockwise.
std::vector<Task> varied(Variation& vary, const glm::vec2& middle, std::vector<Task> tasks)
{
    const PlaneMap map = plane_map(vary, middle);
    for (Task& task : tasks) {
        for (glm::vec2& corner : task.polygon) corner = map.place(corner);
        for (glm::vec2& corner : task.window) corner = map.place(corner);
        if (map.mirrors()) std::reverse(task.window.begin(), task.window.end());
        task.unit = other_unit(vary, 8);
    }
    return in_random_order(vary, std::move(tasks));
}

std::vector<Task> by_hand()
{
    std::vector<Task> tasks = {
        {{{1, 1}, {6, 2}, {3, 7}}, square},                 // inside
        {{{9, 1}, {12, 1}, {10, 5}}, square},               // outside
        {{{-6, 7}, {1, 14}, {-6, 14}}, square},             // past a corner
        {{{4, 2}, {12, 4}, {4, 6}}, square},                // one corner outside
        {{{4, 2}, {12, 0.5F}, {12, 6.5F}}, square},         // two outside
        {{{4, -2}, {10, 5}, {3, 9}}, square},               // all outside, yet seen
        {{{-9, -9}, {30, -10}, {-10, 30}}, square},         // round the whole window
        {{{-2, 1}, {10, 1.5F}, {10, 6}, {-2, 5}}, square},  // a band across
        {{{1, 1}, {5, 1}, {6, 6}, {1, 5}}, triangle},       // a slanted side
        {{{-3, 3}, {4, -4}, {11, 3}, {4, 10}}, square},     // eight corners
        {{{2, 2}, {6, 2}, {4, 9}}, {{4, 0}, {8, 4}, {4, 8}, {0, 4}}},
    };
    tasks.push_back({reversed(tasks[3].polygon), square});
    return tasks;
}

// Concave: a comb whose teeth reach in, a letter whose arms do, one round two corners of the window, a star. Then a
// hook round a corner of the window, which does not come in again: whether its bridge leads to that corner and back
// depends on which of the two sides is cut to first.
std::vector<Task> concave()
{
    std::vector<Task> tasks = {
        {{{10, 1}, {3, 1.5F}, {10, 2}, {10, 3}, {2, 3.5F}, {10, 4}, {10, 5}, {4, 6}, {10, 7}, {12, 7}, {12, 1}},
         square},
        {{{-3, 1}, {5, 1}, {5, 2.5F}, {-1, 2.5F}, {-1, 5}, {6, 5}, {6, 7}, {-3, 7}}, square},
        {{{4, -4}, {12, -4}, {12, 4.5F}, {6, 4}, {6, 3}, {10, 3}, {10, -2}, {5, -2}, {4.5F, 2}, {3.5F, 2}}, square},
        {{{4, 11}, {3, 5}, {-3, 5.5F}, {2, 3}, {1, -3}, {4.5F, 2}, {8, -2}, {6, 3.25F}, {11, 5}, {5, 5.25F}}, square},
        {{{-2, 6}, {-2, -2}, {6, -2}, {3, 3}, {1, -1}, {-1, 1}, {3.5F, 3.5F}}, triangle},
        // Notches that end on a side of the window: that corner stays, though both beside it lie outside.
        {{{4, 1}, {12, 1}, {8, 4}, {12, 7}, {4, 7}}, square},
        {{{1, 3}, {7, 3}, {7, 11}, {5, 8}, {4, 11}, {3, 8}, {1, 12}}, square},
        // Hooks that begin and end in one corner on a side of the window: their bridge leads from there and back.
        {{{3, 4}, {8, 5}, {12, 5}, {12, 12}, {4, 12}, {4, 13}, {13, 13}, {13, 4}, {8, 5}, {3, 6}}, square},
        {{{2, 5}, {3, 0}, {3, -2}, {10, -2}, {10, 6}, {11, 6}, {11, -3}, {2, -3}, {3, 0}, {5, 3}}, square},
    };
    Polygon window = square;
    for (std::size_t first = 0; first < window.size(); ++first) {
        tasks.push_back({{{4, 3}, {12, 3}, {12, 12}, {4, 12}, {4, 10}, {10, 10}, {10, 5}, {4, 5}}, window});
        std::rotate(window.begin(), window.begin() + 1, window.end());
    }
    return tasks;
}

// The same ones again, very small and very large.
std::vector<Task> in_all_sizes(std::vector<Task> tasks)
{
    for (std::size_t i = 0, count = tasks.size(); i < count; ++i) {
        tasks.push_back(tasks[i]);
        tasks.back().unit = i % 2 == 0 ? 0x1p-14F : 0x1p12F;
    }
    return tasks;
}

// Whether samples of the picture lie in what is left, by the even-odd rule: bridges count for nothing, in whatever
// order they come.
void record_covered(Recorder& out, const std::vector<Task>& tasks)
{
    constexpr int size = 32;
    Grid<std::uint32_t> covered(size * static_cast<int>(tasks.size()), size);
    for (std::size_t t = 0; t < tasks.size(); ++t) {
        const Polygon left = answer(out, tasks[t]);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const glm::dvec2 p(-4 + 0.503 * x, -4 + 0.4973 * y);
                bool inside = false;
                for (std::size_t i = 0, j = left.size() - 1; i < left.size(); j = i++) {
                    const glm::dvec2 a(left[i]);
                    const glm::dvec2 b(left[j]);
                    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
                        inside = !inside;
                }
                covered.at(static_cast<int>(t) * size + x, size - 1 - y) =
                    inside ? 1 + static_cast<std::uint32_t>(t) : 0;
            }
    }
    out.buffer("covered", covered);
}

// Corners and sides on the window's sides. Those that leave nothing stand between some that do.
std::vector<Task> borders()
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return {
        {{{8, 4}, {3, 6}, {2, 1}}, square},    // a corner on the right side
        {{{8, 4}, {3, 10}, {2, 1}}, square},   // … and another above
        {{{8, 4}, {11, 6}, {12, 1}}, square},  // … touches from outside: nothing
        {{{8, 2}, {8, 6}, {4, 3}}, square},    // a side on it
        {{{8, 2}, {8, 6}, {12, 3}}, square},   // … from outside: nothing
        {square, square},                      // the window itself
        {reversed(square), square},
        {{{8, 8}, {2, 7}, {7, 2}}, square},            // a corner in a corner
        {{{4, 4}, {6, 2}, {6, 6}, {2, 6}}, triangle},  // a corner on a slanted side, the others beyond it or below
        {{{1, 1}, {5, 1}}, square},                    // two corners: nothing
        {{{1, 1}}, square},                            // one, and none
        {{}, square},
        {{{1, 1}, {nan, 1}, {4, 5}}, square},  // nonsense: nothing
        {{{1, 1}, {infinity, 1}, {4, 5}}, square},
        {{{1, 1}, {7, 2}, {3, -infinity}}, square},
        {{{1, 1}, {7, 2}, {3, 5}}, {{0, 0}, {infinity, 0}, {0, 8}}},
        {{{1, 1}, {7, 2}, {3, 5}}, {{0, 0}, {infinity, 7}, {0, 8}}},
        {{{1, 1}, {nan, 1}, {7, 5}, {1, 6}}, square},         // without the nonsense a triangle would be left
        {{{2, 3}, {8, 3}, {10, 5}, {8, 7}, {2, 6}}, square},  // corners on the side, and beyond it between them
        {{{-2, 8}, {4, 3}, {10, 8}}, square},                 // a side along the upper border, and beyond it
        // A corner so little beyond the side that the two new ones are the same floats: three corners are left.
        {{{8 + 0x1p-20F, 6}, {3, 6.75F}, {3, 5}}, square},
        {{{3, 5}, {8 + 0x1p-20F, 6}, {3, 6.75F}}, square},
        {{{3, 6.75F}, {3, 5}, {8 + 0x1p-20F, 6}}, square},
        {{{1, 1}, {1, 1}, {6, 2}, {3, 7}}, square},  // a corner twice in a row: once is left
        {{{1, 1}, {6, 2}, {3, 7}, {1, 1}}, square},
        {{{1, 1}, {4, 1}, {7, 1}, {4, 6}}, square},  // a corner in the middle of a straight side stays
        {{{8, 2}, {8, 4}, {8, 6}, {4, 3}}, square},  // … also on a side of the window
        {{{1, 1}, {7, 2}, {5, 6}, {2, nan}}, square},
        {{{1, 1}, {7, 2}, {3, 5}}, {{0, 0}, {8, 0}, {8, 8}, {0, nan}}},
        // Three corners or more, until those that come twice in a row count once: nothing.
        {{{1, 1}, {1, 1}, {6, 2}}, square},
        {{{1, 1}, {6, 2}, {1, 1}}, square},
        {{{3, 5}, {3, 5}, {3, 5}}, square},
        {{{5, 2}, {2, 4}, {2, 4}, {5, 2}}, square},
        {{{8, 3}, {8, 3}, {12, 6}, {8, 5}}, square},
        {{{12, 9}, {8, 8}, {8, 8}, {8, 8}, {9, 12}}, square},  // … in a corner of the window, from outside
        // A corner so little inside that the two new ones are the same floats, and both are its y.
        {{{8 - 0x1p-21F, 6}, {12, 5}, {12, 7}}, square},
        {{{3, 8 - 0x1p-21F}, {4, 12}, {2, 12}}, square},
    };
}

/// A corner twice in a row: somewhere, or the first one at the end again, as where outlines are closed so.
void repeat_a_corner(Random& random, Polygon& polygon)
{
    const std::uint32_t i = random.below(2 * static_cast<std::uint32_t>(polygon.size()));
    if (i >= polygon.size())
        polygon.push_back(polygon.front());
    else
        polygon.insert(polygon.begin() + i, polygon[i]);
}

/// Two corners, one of them twice or both: whoever counts before dropping takes them for a polygon.
Polygon two_corners(Random& random, const Polygon& window)
{
    const glm::vec2 one = (window[0] + window[1] + window[2]) / 3.0F;
    const glm::vec2 other = glm::mix(one, window[random.below(3)], random.uniform(0.2F, 0.7F));
    Polygon polygon{one, one, other, other};
    if (random.below(2) == 0) polygon.erase(polygon.begin() + random.below(4));
    return polygon;
}

/// A number for which nothing is left.
void spoil(Random& random, Polygon& polygon)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const std::array nonsense{std::numeric_limits<float>::quiet_NaN(), infinity, -infinity};
    glm::vec2& corner = polygon[random.below(static_cast<std::uint32_t>(polygon.size()))];
    corner[static_cast<int>(random.below(2))] = nonsense[random.below(3)];
}

std::vector<Task> random_tasks(Random& random, int count, bool with_concave)
{
    std::vector<Task> tasks;
    for (int i = 0; i < count; ++i) {
        const bool rough = with_concave && i % 2 == 0;
        // Two have more corners than an array that seems large enough.
        const std::uint32_t most = i % 100 == 22 ? 300 + random.below(400) : 3 + random.below(rough ? 9 : 5);
        Polygon polygon = random_polygon(random, most, rough ? 1.0F : 0.0F);
        if (i % 12 == 3) polygon = times(polygon, 0.15F);  // inside, mostly
        if (i % 6 == 3) repeat_a_corner(random, polygon);
        const std::uint32_t sides = i % 8 == 7 ? 12 + random.below(29) : 3 + random.below(5);
        tasks.push_back({std::move(polygon), random_window(random, sides), random_unit(random, -24, 12)});
        if (i % 8 == 1) tasks.back().polygon = two_corners(random, tasks.back().window);
        if (i % 12 == 5) spoil(random, i % 24 == 5 ? tasks.back().polygon : tasks.back().window);
    }
    return tasks;
}

// Triangles with all corners up to half a million windows away, and a side that leads through the window.
std::vector<Task> far_tasks(Random& random, int count)
{
    std::vector<Task> tasks;
    for (int i = 0; i < count; ++i) {
        const Polygon window = random_window(random, 3 + random.below(4));
        glm::vec2 middle(0);
        for (const glm::vec2& corner : window) middle += corner / static_cast<float>(window.size());
        const glm::vec2 through = middle + 0.2F * glm::vec2(random.in_cube());
        const float turn = random.uniform(0, 6.2831853F);
        const auto away = [&](float angle) {
            return through + std::exp2(random.uniform(10, 19)) * glm::vec2(std::cos(angle), std::sin(angle));
        };
        const glm::vec2 one = away(turn);
        const glm::vec2 other = away(turn + 3.1415927F);
        const glm::vec2 third = away(turn + random.uniform(0.5F, 2.6F));
        tasks.push_back({{one, other, third}, window, random_unit(random, -80, 90)});
    }
    return tasks;
}

// Triangles with a side that crosses a side of the window at an angle of a few millionths.
std::vector<Task> grazing_tasks(Random& random, int count)
{
    std::vector<Task> tasks;
    for (int i = 0; i < count; ++i) {
        const Polygon window = random_window(random, 3 + random.below(3));
        const glm::vec2 a = window[0];
        const glm::vec2 b = window[1];
        const glm::vec2 inwards(a.y - b.y, b.x - a.x);
        const auto beside = [&](float along, float off) { return glm::mix(a, b, along) + off * inwards; };
        const glm::vec2 inner = beside(random.uniform(0.15F, 0.3F), random.uniform(2e-6F, 1e-5F));
        const glm::vec2 outer = beside(random.uniform(0.7F, 0.85F), -random.uniform(2e-6F, 1e-5F));
        tasks.push_back({{inner, outer, beside(random.uniform(0.4F, 0.6F), 0.2F)}, window});
    }
    return tasks;
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record(out, varied(c.vary, glm::vec2(4), by_hand())); }},
    {"concave",
     [](Case& c, Recorder& out) {
         const std::vector<Task> tasks = varied(c.vary, glm::vec2(4), concave());
         record(out, tasks);
         record_covered(out, in_all_sizes(tasks));
     }},
    {"borders", [](Case& c, Recorder& out) { record(out, varied(c.vary, glm::vec2(0), borders())); }},
    {"random", [](Case& c, Recorder& out) { record(out, random_tasks(c.random, 200, true)); }},
    {"far", [](Case& c, Recorder& out) { record(out, far_tasks(c.random, 150)); }},
    {"grazing", [](Case& c, Recorder& out) { record(out, grazing_tasks(c.random, 150)); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_spiral(out, c.vary)); }},
};

}
