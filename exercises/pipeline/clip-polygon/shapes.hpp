#pragma once

#include <algorithm>
#include <cmath>
#include <kit/drawing.hpp>
#include <numbers>
#include <umbral/core/random.hpp>
#include <umbral/pipeline/clip_polygon.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

/// Polygons and windows for pipeline/clip-polygon, and its goal picture.
namespace umbral::pipeline {

using Polygon = std::vector<glm::vec2>;

/// What the unit makes of them; no more corners than any right answer has.
inline Polygon clipped(Recorder& out, const Polygon& polygon, const Polygon& window)
{
    Polygon result = ask<clip_polygon>(out, polygon, window);
    result.resize(std::min<std::size_t>(result.size(), 40 + 4 * polygon.size()));
    return result;
}

/// Counter-clockwise, convex: corners on a circle.
inline Polygon random_window(Random& random, std::uint32_t corners)
{
    const glm::vec2 middle = 0.4F * glm::vec2(random.in_cube());
    const float radius = random.uniform(0.7F, 1.3F);
    const float turn = random.uniform(0, 6.2831853F);
    Polygon window;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const float angle =
            turn + (static_cast<float>(i) + random.uniform(-0.3F, 0.3F)) / static_cast<float>(corners) * 6.2831853F;
        window.push_back(middle + radius * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    return window;
}

/// Round a point, so that no sides cross: convex if `rough` is 0, spiky if it is 1. Turns either way.
inline Polygon random_polygon(Random& random, std::uint32_t corners, float rough)
{
    const glm::vec2 middle = 0.6F * glm::vec2(random.in_cube());
    const float size = random.uniform(0.6F, 1.6F);
    Polygon polygon;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const float angle =
            (static_cast<float>(i) + random.uniform(-0.35F, 0.35F)) / static_cast<float>(corners) * 6.2831853F;
        const float radius = size * (1 - rough * 0.8F * random.uniform());
        polygon.push_back(middle + radius * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    if (random.below(2) == 0) std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

/// A spiral band that begins at an angle: one polygon, of which a window sees many pieces.
inline Polygon spiral(int steps, double first_angle)
{
    Polygon outer;
    Polygon inner;
    for (int i = 0; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        const double angle = first_angle + 6.4 * std::numbers::pi * part;
        const double radius = 0.12 + 1.12 * part;
        const double half = 0.035 + 0.065 * part;
        const glm::dvec2 outwards(std::cos(angle), std::sin(angle));
        outer.emplace_back((radius + half) * outwards);
        inner.emplace_back((radius - half) * outwards);
    }
    outer.insert(outer.end(), inner.rbegin(), inner.rend());
    return outer;
}

/// Fills a polygon row by row, by the even-odd rule; Drawing::area would ask every pixel about every side.
inline void fill(Drawing& drawing, const Polygon& polygon, glm::vec3 color, double low, double high, int rows)
{
    std::vector<double> crossings;
    for (int row = 0; row < rows; ++row) {
        const double y = low + (high - low) * (row + 0.5) / rows;
        crossings.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec2 a(polygon[i]);
            const glm::dvec2 b(polygon[(i + 1) % polygon.size()]);
            const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
            if ((a.y > y) != (b.y > y) && std::isfinite(x)) crossings.push_back(x);
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
            drawing.line({crossings[k], y}, {crossings[k + 1], y}, color, 1);
    }
}

/// The spiral in a slanted window: what is left is filled, with its bridges, and dots at new corners; the rest is a
/// thin line.
inline Image draw_spiral(Recorder& out, Variation& vary)
{
    constexpr double half = 1.34;
    constexpr int size = 500;
    const Polygon band = spiral(120, vary.near(0.6, 1.5));
    Polygon window = {{-0.88F, -0.42F}, {-0.1F, -0.92F}, {0.98F, -0.5F}, {0.72F, 0.62F}, {-0.46F, 0.78F}};
    for (glm::vec2& corner : window) corner = vary.near(corner, 0.12F);
    const Polygon left = clipped(out, band, window);
    const auto wide = [](const Polygon& polygon) { return std::vector<glm::dvec2>(polygon.begin(), polygon.end()); };

    Drawing drawing(size, size, {-half, -half}, {half, half});
    fill(drawing, band, 0.55F * ink::slate, -half, half, size);
    drawing.outline(wide(band), ink::slate, 1.5);
    fill(drawing, left, ink::orange, -half, half, size);
    drawing.outline(wide(window), ink::blue, 2);
    drawing.outline(wide(left), ink::white, 2);
    for (const glm::vec2& corner : left)
        if (std::find(band.begin(), band.end(), corner) == band.end()) drawing.disc(corner, 4, ink::white);
    return drawing.picture();
}

}
