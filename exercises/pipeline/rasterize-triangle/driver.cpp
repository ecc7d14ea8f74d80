#include <kit/varied.hpp>
#include <limits>
#include <umbral/record/driver.hpp>

#include "far_off.hpp"
#include "scene.hpp"

namespace umbral {
namespace {

using namespace pipeline;

Triangle triangle(glm::vec2 a, glm::vec2 b, glm::vec2 c)
{
    return {WindowVertex{a, 0, 1}, {b, 0.5F, 0.5F}, {c, 1, 0.25F}};
}

// Eight by eight pixels, corners in quarters: all can be worked out on squared paper.
std::vector<Triangle> by_hand()
{
    std::vector<Triangle> triangles = {
        triangle({1, 1}, {7, 1}, {1, 7}),                         // a side through centres that is neither top nor left
        triangle({7, 7}, {1, 7}, {7, 1}),                         // … and its other half, which takes them
        triangle({1.5F, 1.5F}, {5.5F, 1.5F}, {5.5F, 5.5F}),       // corners on centres: a top side and a left one
        triangle({1.5F, 1.5F}, {1.5F, 5.5F}, {5.5F, 5.5F}),       // … a left side and a bottom one
        triangle({4, 0.25F}, {7.75F, 7.5F}, {0.25F, 7.5F}),       // clockwise
        triangle({4, 0.25F}, {0.25F, 7.5F}, {7.75F, 7.5F}),       // the same, counter-clockwise
        triangle({3.25F, 3.25F}, {3.75F, 3.25F}, {3.5F, 3.75F}),  // round one centre
        triangle({2.75F, 2.75F}, {3.25F, 2.75F}, {3, 3.25F}),     // between the centres: nothing
        triangle({-3, 2}, {4, -5}, {12, 11}),                     // clipped on all sides
        triangle({0.5F, 0}, {0.5F, 8}, {1.5F, 4}),                // a left side on centres
        triangle({7.5F, 0}, {7.5F, 8}, {6.5F, 4}),                // a right one, which takes none
        triangle({0, 7.5F}, {8, 7.5F}, {4, 5.5F}),                // a bottom one, neither
        triangle({0.5F, 0.5F}, {0.5F + 1.0F / 256, 0.5F}, {0.5F, 0.5F + 1.0F / 256}),  // the least that there is
        triangle({1, 1}, {7, 2}, {2, 7}),
        triangle({1, 1}, {6, 2}, {2, 6}),
    };
    const std::size_t last = triangles.size() - 1;
    for (WindowVertex& vertex : triangles[last - 1]) vertex.inverse_w *= 0x1p-40F;  // far away, in small units
    for (WindowVertex& vertex : triangles[last]) vertex.inverse_w *= 0x1p40F;       // near, in large ones
    return triangles;
}

/// Triangles in a picture of 8 x 8 pixels, mirrored or turned about its middle, each begun at another corner, in
/// another order: what passes through centres still does.
std::vector<Triangle> varied(Variation& vary, std::vector<Triangle> triangles)
{
    const PlaneMap map = plane_map(vary, glm::vec2(4));
    for (Triangle& corners : triangles) {
        for (WindowVertex& vertex : corners) vertex.position = map.place(vertex.position);
        std::rotate(corners.begin(), corners.begin() + vary.one_of(0, std::array{1, 2}), corners.end());
    }
    return in_random_order(vary, std::move(triangles));
}

std::vector<Triangle> random_triangles(Random& random, int count, int width, int height)
{
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; ++i) {
        std::array<glm::vec2, 3> corners{};
        for (glm::vec2& corner : corners) {
            corner.x = on_grid(random, -width / 4, width + width / 4, 16);
            corner.y = on_grid(random, -height / 4, height + height / 4, 16);
            // Beside a grid point by less than what is rounded away.
            if (i % 4 == 1) corner += 0.0018F * glm::vec2(random.in_cube());
        }
        // Sometimes the same corners as before, with other numbers.
        if (i % 5 == 4)
            for (std::size_t k = 0; k < 3; ++k) corners[k] = triangles.back()[k].position;
        triangles.push_back(random_attributes(random, corners));
        // Weights are the same in whatever unit w is counted.
        const float unit = i % 8 == 3 ? random_unit(random, -60, 60) : 1;
        for (WindowVertex& vertex : triangles.back()) vertex.inverse_w *= unit;
    }
    return triangles;
}

// Fans about a centre, a corner and a middle of a side of a pixel; meshes whose corners lie on centres.
std::vector<Triangle> shared_edges(Random& random)
{
    std::vector<std::array<glm::vec2, 3>> all = random_partition(random, 8);
    for (const glm::vec2 centre : {glm::vec2(16.5F, 16.5F), {16, 16}, {16, 16.5F}, {16.5F, 16}}) {
        const std::vector<std::array<glm::vec2, 3>> more = fan(random, centre, 12);
        all.insert(all.end(), more.begin(), more.end());
    }
    return with_attributes(random, all);
}

/// Spoils a corner in one of `spoilings` ways: nothing may be drawn of a triangle that has it.
constexpr int spoilings = 13;
void spoil(WindowVertex& vertex, int how)
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    switch (how) {
        case 0: vertex.position.x = nan; break;
        case 1: vertex.position.y = nan; break;
        case 2: vertex.depth = nan; break;
        case 3: vertex.inverse_w = nan; break;
        case 4: vertex.inverse_w = 0; break;
        case 5: vertex.inverse_w = -1; break;
        case 6: vertex.position.y = -infinity; break;
        case 7: vertex.position.x = 16385; break;
        case 8: vertex.position.x = -16385; break;
        case 9: vertex.position.y = 16385; break;
        case 10: vertex.position.y = -16385; break;
        case 11: vertex.inverse_w = -0x1p-100F; break;
        default: vertex.position.x = infinity;
    }
}

// Triangles that must leave no trace, between ones that must.
std::vector<Triangle> nothing(Random& random)
{
    std::vector<Triangle> none = {
        triangle({1, 1}, {7, 1}, {5.5F, 1}),
        triangle({0.5F, 0.5F}, {3.5F, 3.5F}, {6.5F, 6.5F}),
        triangle({2.5F, 2.5F}, {2.5F, 2.5F}, {2.5F, 2.5F}),
        triangle({-9, -9}, {-1, -9}, {-9, -1}),
    };
    for (std::size_t corner = 0; corner < 3; ++corner)
        for (int how = 0; how < spoilings; ++how) {
            none.push_back(triangle({1, 1}, {7, 1}, {1, 7}));
            spoil(none.back()[corner], how);
        }
    std::vector<Triangle> triangles;
    for (const Triangle& next : none) {
        triangles.push_back(triangle({1, 1}, {7, 1.5F}, {2, 7}));
        triangles.push_back(next);
        const float x = on_grid(random, 2, 6, 4);
        triangles.push_back(triangle({x, 0.25F}, {7.25F, 7.25F}, {0.25F, 7.25F}));
    }
    return triangles;
}

/// Asks about a triangle in a picture of its own size; what it covers belongs to triangle `number`.
void cover(Recorder& out, std::size_t number, const Triangle& next, int width, int height)
{
    std::vector<Fragment> fragments;
    ask<rasterize_triangle>(out, next, width, height, fragments);
    for (const Fragment& fragment : fragments)
        out.append("coverage", glm::vec3(static_cast<float>(number), static_cast<float>(fragment.pixel.x),
                                         static_cast<float>(fragment.pixel.y)));
}

// A picture without pixels shows nothing.
void record_nothing(Random& random, Recorder& out)
{
    const std::vector<Triangle> triangles = nothing(random);
    record(out, triangles, 8, 8, false);
    for (std::size_t i = 0; i < 3; ++i)
        cover(out, triangles.size() + i, triangle({-1, -1}, {7, -1}, {-1, 7}), i == 0 ? 8 : 0, i == 1 ? 8 : 0);
}

std::vector<Triangle> unrounded(Random& random)
{
    std::vector<std::array<glm::vec2, 3>> corners;
    for (int i = 0; i < 250; ++i) corners.push_back(unrounded_triangle(random, 24));
    for (int i = 0; i < 150; ++i) corners.push_back(half_box_beside_centres(random, 24));
    return with_attributes(random, corners);
}

void guard_band(Random& random, Recorder& out)
{
    std::vector<std::array<glm::vec2, 3>> corners;
    constexpr int width = 24, height = 40;  // a picture that is higher than wide
    for (int i = 0; i < 40; ++i) corners.push_back(huge_triangle(random, width, height, false));
    for (int i = 0; i < 160; ++i) corners.push_back(huge_triangle(random, width, height, true));
    // Corners exactly on its border, which belongs to it, and so little beyond that they round to it.
    for (const float end : {16384.0F, -16384.0F, 16384.001953125F, -16384.001953125F}) {
        corners.push_back({glm::vec2(end, 4), {2, 2}, {2, 30}});
        corners.push_back({glm::vec2(8, end), {2, 2}, {20, 2}});
    }
    corners.push_back({glm::vec2(1, 16384), {2, -16384}, {9, 16384}});
    const std::vector<std::array<glm::vec2, 3>> border = on_the_border(random);
    corners.insert(corners.end(), border.begin(), border.end());
    const std::vector<Triangle> triangles = with_attributes(random, corners);
    record(out, triangles, width, height, false);
    // At the far end of the widest and of the highest picture that there are.
    for (std::size_t i = 0; i < 20; ++i) {
        const bool wide = i % 2 == 0;
        const float end = on_grid(random, 8190, 16380, 256);
        const auto corner = [&](float along, float across) {
            return wide ? glm::vec2(end + along, across) : glm::vec2(across, end + along);
        };
        const Triangle far_off = triangle(corner(0, 0.25F), corner(3, 2.75F), corner(-3, 2.5F));
        cover(out, triangles.size() + i, far_off, wide ? 16384 : 3, wide ? 3 : 16384);
    }
}

// So thin or small that most cover one pixel or none, which hangs on the last of 47 bits. Twenty-five make a group.
void needles(Random& random, Recorder& out)
{
    std::vector<std::array<glm::vec2, 3>> corners;
    for (int i = 0; i < 300; ++i) corners.push_back(needle(random, 40, 24, 16000, random.below(2) == 0));
    for (int i = 0; i < 150; ++i) corners.push_back(speck(random, 40, 24));
    record(out, with_attributes(random, corners), 40, 24, false, 25);
    out.text("coverage.names", "group of needles");
}

void cover(Recorder& out, std::string_view name, const std::vector<Triangle>& triangles, std::size_t together)
{
    std::vector<Fragment> fragments;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        fragments.clear();
        ask<rasterize_triangle>(out, triangles[i], 40, 32, fragments);
        for (const Fragment& fragment : fragments)
            out.append(name, glm::vec3(static_cast<float>(i / together), static_cast<float>(fragment.pixel.x),
                                       static_cast<float>(fragment.pixel.y)));
    }
}

// Triangles, the same ones moved by whole pixels, and cut in two from a corner to the middle of a side. Corners are
// multiples of 1/2 or 1/128 pixel, so that the middle is exact, and many cuts pass through centres.
void laws(Random& random, Recorder& out)
{
    std::vector<Triangle> whole;
    std::vector<Triangle> moved;
    std::vector<Triangle> halves;
    std::vector<Triangle> first_halves;
    for (int i = 0; i < 30; ++i) {
        std::array<glm::vec2, 3> corners{};
        for (glm::vec2& corner : corners) {
            corner.x = on_grid(random, 1, 30, i % 2 == 0 ? 2 : 128);
            corner.y = on_grid(random, 1, 27, i % 2 == 0 ? 2 : 128);
        }
        const auto& [a, b, c] = corners;
        const glm::vec2 middle = 0.5F * (b + c);
        const glm::vec2 step(7, 3);
        whole.push_back(triangle(a, b, c));
        moved.push_back(triangle(a + step, b + step, c + step));
        halves.push_back(triangle(a, b, middle));
        halves.push_back(triangle(a, middle, c));
        first_halves.push_back(triangle(a, b, middle));
    }
    cover(out, "whole", whole, 1);
    cover(out, "moved", moved, 1);
    cover(out, "two halves", halves, 2);
    cover(out, "one half", first_halves, 1);
}

// One list for all triangles, two of them twice, with a row of somebody else's at its beginning.
void record_list(Random& random, Recorder& out)
{
    std::vector<Fragment> fragments = {{{3, 2}, 0.5F, {1, 0, 0}}};
    const std::vector<Triangle> all = random_triangles(random, 8, 10, 14);
    for (const std::size_t i : {0U, 1U, 2U, 3U, 3U, 4U, 5U, 6U, 7U, 7U})
        ask<rasterize_triangle>(out, all[i], 10, 14, fragments);
    fragments.resize(std::min<std::size_t>(fragments.size(), 2000));
    for (const Fragment& fragment : fragments)
        out.append("rows", glm::vec3(1, static_cast<float>(fragment.pixel.x), static_cast<float>(fragment.pixel.y)));
    out.text("rows.names", "1 fragment\n");
}

void record_picture(Variation& vary, Recorder& out)
{
    const Canvas canvas = scene(out, vary, 480, 320);
    out.image("colours", encoded(canvas.colours));
    out.buffer("ids", canvas.ids);
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record(out, varied(c.vary, by_hand()), 8, 8, true); }},
    {"random", [](Case& c, Recorder& out) { record(out, random_triangles(c.random, 40, 50, 38), 50, 38, true); }},
    {"shared edges", [](Case& c, Recorder& out) { record(out, shared_edges(c.random), 32, 32, false); }},
    {"nothing", [](Case& c, Recorder& out) { record_nothing(c.random, out); }},
    {"between grid points", [](Case& c, Recorder& out) { record(out, unrounded(c.random), 24, 24, false); }},
    {"guard band", [](Case& c, Recorder& out) { guard_band(c.random, out); }},
    {"needles", [](Case& c, Recorder& out) { needles(c.random, out); }},
    {"horizon", [](Case& c, Recorder& out) { record(out, horizon(c.random), 40, 24, true); }},
    {"list", [](Case& c, Recorder& out) { record_list(c.random, out); }},
    {"laws", [](Case& c, Recorder& out) { laws(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
