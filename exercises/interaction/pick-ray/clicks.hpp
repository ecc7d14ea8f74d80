#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "../pick_views.hpp"

/// Clicks whose pixel is known, and clicks beside the window.
namespace umbral::interaction {

/// One question put to pick_pixel.
struct Click {
    glm::dvec2 cursor;
    glm::ivec2 window;
    glm::ivec2 framebuffer;
};

/// Adds a click that has a pixel and one that has none, in random order.
inline void add_pair(std::vector<Click>& clicks, const Click& inside, const Click& outside, Random& random)
{
    const bool swapped = random.below(2) == 1;
    clicks.push_back(swapped ? outside : inside);
    clicks.push_back(swapped ? inside : outside);
}

/// The window of a framebuffer whose pixels are `scale` times as many along each axis, rounded to whole numbers.
inline Click click_at(const glm::dvec2& place, const glm::ivec2& framebuffer, const glm::dvec2& scale)
{
    const glm::ivec2 window(glm::round(glm::dvec2(framebuffer) / scale));
    return {place * glm::dvec2(window) / glm::dvec2(framebuffer), window, framebuffer};
}

/// In the inner 80 % of a pixel: no rounding leads out of it.
inline glm::dvec2 inside_of(const glm::ivec2& pixel, Random& random)
{
    const double right = 0.1 + 0.8 * random.uniform_double();
    return glm::dvec2(pixel) + glm::dvec2(right, 0.1 + 0.8 * random.uniform_double());
}

/// Screens as they are sold, and others; the picture is never square.
inline constexpr std::array content_scales = {1.0, 1.25, 1.5, 1.75, 2.0, 3.0, 0.5, 1.6, 2.625, 4.0 / 3};

/// `count` pairs: the twin of a click in the window is beside it, to each of its four sides, from a hundredth of a
/// screen coordinate to a window's width away.
inline std::vector<Click> random_clicks(Random& random, int count)
{
    std::vector<Click> clicks;
    for (int i = 0; i < count; ++i) {
        const int width = random_between(200, 3000, random);
        const glm::ivec2 framebuffer(width, random_between(150, 2000, random));
        const double scale = content_scales[random.below(static_cast<std::uint32_t>(content_scales.size()))];
        const Click inside =
            click_at(inside_of(random_pixel(framebuffer, random), random), framebuffer, glm::dvec2(scale));
        Click outside = inside;
        const int axis = i % 2;
        const double beyond = std::exp2(-7 + 15 * random.uniform_double());
        outside.cursor[axis] = i % 4 < 2 ? -beyond : inside.window[axis] + beyond;
        add_pair(clicks, inside, outside, random);
    }
    return clicks;
}

/// `count` pairs at pixels' borders, where all numbers are exact, with scales that differ along the axes: a pixel owns
/// the left and the upper one, so the window's right and lower border belong to no pixel, and what lies a hair beyond 0
/// neither.
inline std::vector<Click> clicks_at_borders(Random& random, int count)
{
    constexpr std::array exact_scales = {1.0, 2.0, 4.0, 0.5};
    std::vector<Click> clicks;
    for (int i = 0; i < count; ++i) {
        const auto along_x = random.below(4);
        const glm::dvec2 scale(exact_scales[along_x], exact_scales[(along_x + random.below(2)) % 4]);
        const int width = 4 * random_between(50, 300, random);
        const glm::ivec2 framebuffer(width, 4 * random_between(30, 200, random));
        const glm::ivec2 pixel = random_pixel(framebuffer, random);
        const int axis = i % 2;
        glm::dvec2 place = glm::dvec2(pixel) + 0.5;
        place[axis] = i % 8 < 2 ? 0 : i % 8 < 4 ? framebuffer[axis] - 0.0625 : pixel[axis];
        const Click inside = click_at(place, framebuffer, scale);
        place[axis] = i % 4 < 2 ? framebuffer[axis] : -0.0625;
        add_pair(clicks, inside, click_at(place, framebuffer, scale), random);
    }
    return clicks;
}

/// `count` pairs at whole places of the cursor, as many systems tell them, which are borders between pixels on screens
/// of scale 1, 2, 3, and every second one of scale 1.5. Sizes are such that cursor / window * framebuffer, which rounds
/// before it multiplies, comes to lie before the border, in the wrong pixel; cursor * framebuffer, the scale and the
/// size of a pixel are exact, or lead to the border all the same.
inline std::vector<Click> clicks_at_whole_places(Random& random, int count)
{
    constexpr std::array scales = {2, 4, 6, 3};  // in halves
    const auto place = [&](int window, int half_scale) {
        const int first = random_between(0, window / 2 - 1, random);
        for (int i = 0; i < window / 2; ++i) {
            const double cursor = 2.0 * ((first + i) % (window / 2));
            if (cursor / window * (window * half_scale / 2) < cursor * half_scale / 2) return cursor;
        }
        return 2.0 * first;
    };
    std::vector<Click> clicks;
    for (int i = 0; i < count; ++i) {
        const int half_scale = scales.at(static_cast<std::size_t>(i) % scales.size());
        const glm::ivec2 window(2 * random_between(300, 900, random), 2 * random_between(200, 600, random));
        const Click inside{{place(window.x, half_scale), place(window.y, half_scale)}, window, window * half_scale / 2};
        Click outside = inside;
        const int axis = i / 4 % 2;
        outside.cursor[axis] = i % 2 == 0 ? window[axis] : -1;
        add_pair(clicks, inside, outside, random);
    }
    return clicks;
}

/// A cursor on a border between pixels of a window `window` wide, of whose framebuffer the scale is no short fraction.
struct OddBorder {
    int window;
    int framebuffer;
    int cursor;

    [[nodiscard]] int pixel() const { return static_cast<int>(std::int64_t{cursor} * framebuffer / window); }
    /// Does the cursor come to lie before the border, if the scale is computed first, or the size of a pixel?
    [[nodiscard]] bool is_missed_by_scale() const
    {
        return cursor * (static_cast<double>(framebuffer) / window) < pixel();
    }
    [[nodiscard]] bool is_missed_by_size() const
    {
        return cursor / (static_cast<double>(window) / framebuffer) < pixel();
    }
};

/// A border that one of the two ways misses. About one in thirty is missed by either.
inline OddBorder odd_border(Random& random, bool by_scale)
{
    OddBorder border{110, 248, 55};
    if (!by_scale) border = {732, 878, 366};
    for (int i = 0; i < 1000; ++i) {
        const int steps = random_between(8, 40, random);
        const int window = random_between(10, 25, random);
        const int framebuffer = random_between(window, 3 * window, random);
        const OddBorder drawn{steps * window, steps * framebuffer, window * random_between(1, steps - 1, random)};
        if (by_scale ? drawn.is_missed_by_scale() : drawn.is_missed_by_size()) return drawn;
    }
    return border;
}

/// `count` pairs at whole places of the cursor where the product cursor * framebuffer leads to the border, and both the
/// scale framebuffer / window and the size of a pixel, window / framebuffer, are rounded such that one of them leads
/// into the pixel before it: along one axis the first, along the other one the second.
inline std::vector<Click> clicks_at_odd_scales(Random& random, int count)
{
    constexpr std::array<OddBorder, 4> known = {{{190, 238, 95}, {732, 878, 366}, {110, 248, 55}, {174, 218, 87}}};
    std::vector<Click> clicks;
    for (int i = 0; i < count; ++i) {
        const bool first = i % 2 == 0;
        const auto which = static_cast<std::size_t>(i);
        const OddBorder x = which < known.size() ? known.at(which) : odd_border(random, first);
        const OddBorder y = odd_border(random, !first);
        const Click inside{{x.cursor, y.cursor}, {x.window, y.window}, {x.framebuffer, y.framebuffer}};
        Click outside = inside;
        const int axis = i / 2 % 2;
        outside.cursor[axis] = i % 3 == 0 ? inside.window[axis] : -1;
        add_pair(clicks, inside, outside, random);
    }
    return clicks;
}

/// `count` pairs a millionth to a ten-thousandth of a pixel beside borders, on large screens of all scales: before the
/// border and behind it, between two pixels and at the window's four sides.
inline std::vector<Click> clicks_beside_borders(Random& random, int count)
{
    std::vector<Click> clicks;
    for (int i = 0; i < count; ++i) {
        const glm::ivec2 framebuffer(random_between(4000, 16000, random), random_between(3000, 9000, random));
        const glm::dvec2 scale(content_scales[random.below(static_cast<std::uint32_t>(content_scales.size()))]);
        glm::dvec2 place = inside_of(random_pixel(framebuffer, random), random);
        const int axis = i % 2;
        const double hair = std::pow(10.0, -6 + 2 * random.uniform_double());
        const int border = random_between(1, framebuffer[axis] - 1, random);
        place[axis] = border + (random.below(2) == 0 ? hair : -hair);
        const Click inside = click_at(place, framebuffer, scale);
        place[axis] = i % 4 < 2 ? framebuffer[axis] + hair : -hair;
        add_pair(clicks, inside, click_at(place, framebuffer, scale), random);
    }
    return clicks;
}

/// `count` pairs: the twin's window or framebuffer has no area, or its cursor is no place.
inline std::vector<Click> clicks_without_a_window(Random& random, int count)
{
    std::vector<Click> clicks;
    for (int i = 0; i < count; ++i) {
        const glm::ivec2 framebuffer(640 + 2 * i, 480);
        const Click inside = click_at(inside_of(random_pixel(framebuffer, random), random), framebuffer, glm::dvec2(2));
        Click none = inside;
        const int axis = i / 6 % 2;
        switch (i % 6) {
            case 0: none.window = none.framebuffer = {0, 0}; break;
            case 1: none.framebuffer[axis] = 0; break;
            case 2: none.window[axis] = 0; break;
            case 3: none.window = {0, 0}, none.cursor = {0, 0}; break;
            case 4: none.cursor[axis] = std::numeric_limits<double>::quiet_NaN(); break;
            default: none.cursor[axis] = i % 12 < 6 ? 1e300 : -1e300;
        }
        add_pair(clicks, inside, none, random);
    }
    return clicks;
}

}
