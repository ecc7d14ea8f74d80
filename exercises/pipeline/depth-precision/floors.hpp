#pragma once

#include <array>
#include <cmath>
#include <kit/drawing.hpp>
#include <umbral/pipeline/depth_precision.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

/// The goal picture of pipeline/depth-precision: what each format resolves at all distances, and what that does to two
/// floors, one just above the other.
namespace umbral::pipeline {

namespace detail {

struct Curve {
    DepthFormat format;
    bool reversed;
    glm::vec3 color;
};

/// Twelve decades of the resolution, from 1e-9 to 1e3, in the picture's height.
inline double height_of(double decade) { return (decade + 3) / 6; }

/// Decades of the distance to the right, of the resolution upwards.
inline void draw_curves(Recorder& out, Drawing& drawing, double near_plane, double far_plane)
{
    for (int decade = -2; decade <= 3; ++decade) drawing.line({decade, -1.2}, {decade, 1.2}, ink::slate, 1);
    for (int decade = -10; decade <= 3; ++decade)
        drawing.line({-2, height_of(decade)}, {3, height_of(decade)}, ink::slate, 1);
    for (const Curve& curve : {Curve{DepthFormat::unorm16, false, ink::red},
                               {DepthFormat::unorm24, false, ink::orange},
                               {DepthFormat::float32, false, ink::blue},
                               {DepthFormat::float32, true, ink::green}}) {
        constexpr int steps = 900;
        glm::dvec2 last(std::nan(""));
        for (int i = 1; i < steps; ++i) {
            const double decade = -2 + 5.0 * i / steps;
            const double resolution = ask<depth_resolution>(out, {near_plane, far_plane, curve.reversed}, curve.format,
                                                            -std::pow(10, decade));
            const glm::dvec2 place(decade, height_of(std::log10(resolution)));
            drawing.line(last, place, curve.color, 2.5);
            last = place;
        }
    }
    for (const auto& [bits, color] : {std::pair(16, ink::red), {24, ink::orange}})
        for (const double gap : {1e-6, 1e-4, 1e-2})
            if (const std::optional<double> begin = ask<fighting_distance>(out, {near_plane, far_plane}, bits, gap);
                begin && *begin > near_plane)
                drawing.ring({std::log10(*begin), height_of(std::log10(gap))}, 5, color, 2.5);
}

/// A blue floor a ten-thousandth above a red one. Where both have the same depth in the buffer, the red one, drawn
/// last, shows.
inline Image draw_floors(Recorder& out, const DepthRange& range, int bits, int width, int height)
{
    Image picture(width, height, glm::u8vec4(14, 15, 23, 255));
    const auto stored = [&](double distance) {
        const double depth = ask<window_depth>(out, range, -distance);
        return bits > 0 ? static_cast<double>(ask<depth_code>(out, depth, bits)) : double{static_cast<float>(depth)};
    };
    for (int y = height / 8; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double slope = (y - height / 8 + 0.5) / height;
            const double distance = 0.03 / (slope * slope * slope);
            const double aside = distance * (x - 0.5 * width) / height;
            const double above = stored(distance);
            const double below = stored(distance * 1.0001);
            const bool hidden = range.reversed ? below < above : below > above;
            const bool light = (static_cast<long>(std::floor(3 * std::log(distance))) +
                                static_cast<long>(std::floor(4 * aside / distance + 100))) %
                                   2 ==
                               0;
            const glm::vec3 color = (hidden ? ink::blue : ink::red) * (light ? 1.0F : 0.72F);
            picture.at(x, y) = glm::u8vec4(glm::u8vec3(255.0F * color), 255);
        }
    return picture;
}

}

/// The curves above; below them the floors in 16 bits, 24 bits, and reversed floats.
inline Image draw_precision(Recorder& out, Variation& vary)
{
    // Never nearer and farther than the chart's borders: what is asked lies between the planes.
    const double near_plane = vary.one_of(0.01, std::array{0.002, 0.003, 0.005});
    const double far_plane = vary.one_of(1000.0, std::array{2000.0, 4000.0, 9000.0});
    constexpr int part = 200;
    constexpr int curves = 260;
    constexpr int floors = 130;
    Drawing chart(3 * part, curves, {-2, -1.1}, {3, 1.1});
    detail::draw_curves(out, chart, near_plane, far_plane);
    const Image top = chart.picture();
    Image picture(3 * part, curves + floors, glm::u8vec4(14, 15, 23, 255));
    for (int y = 0; y < curves; ++y)
        for (int x = 0; x < 3 * part; ++x) picture.at(x, y) = top.at(x, y);
    const std::array<std::pair<DepthRange, int>, 3> views = {std::pair(DepthRange{near_plane, far_plane}, 16),
                                                             {DepthRange{near_plane, far_plane}, 24},
                                                             {DepthRange{near_plane, far_plane, true}, 0}};
    for (int i = 0; i < 3; ++i) {
        const auto& [range, bits] = views[static_cast<std::size_t>(i)];
        const Image floor = detail::draw_floors(out, range, bits, part - 8, floors);
        for (int y = 0; y < floor.height; ++y)
            for (int x = 0; x < floor.width; ++x) picture.at(i * part + 4 + x, curves + y) = floor.at(x, y);
    }
    return picture;
}

}
