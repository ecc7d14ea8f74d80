#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <umbral/core/random.hpp>
#include <umbral/record/driver.hpp>

#include "flowers.hpp"

namespace umbral {
namespace {

using namespace projections;

void record_pixel(Recorder& out, const Viewport& viewport, const glm::vec2& ndc)
{
    const std::optional<glm::ivec2> pixel = ask<pixel_at>(out, viewport, ndc);
    out.append("pixel column", pixel ? std::optional(static_cast<float>(pixel->x)) : std::nullopt);
    out.append("pixel row", pixel ? std::optional(static_cast<float>(pixel->y)) : std::nullopt);
}

/// Another window, if inputs are to vary: moved, of another size and with other depths. What is a few pixels wide
/// remains so.
Viewport varied(Variation& vary, Viewport viewport)
{
    viewport.left = vary.near(viewport.left, 5);
    viewport.bottom = vary.near(viewport.bottom, 5);
    viewport.width = vary.near(viewport.width, viewport.width / 4);
    viewport.height = vary.near(viewport.height, viewport.height / 4);
    viewport.near_depth = vary.near(viewport.near_depth, 0.2F);
    viewport.far_depth = vary.near(viewport.far_depth, 0.2F);
    return viewport;
}

// A whole window, one of odd size that lies in it, a range of depths, one that is reversed, and one beyond 0 and 1.
void record_known(Variation& vary, Recorder& out)
{
    const Viewport viewports[] = {{0, 0, 640, 480},           {10, 20, 101, 55},    {0, 0, 2, 2},
                                  {5, 6, 8, 4, 0.25F, 0.75F}, {-4, -2, 8, 4, 1, 0}, {3, 1, 16, 2, -1, 3}};
    for (const Viewport& written : viewports) {
        const Viewport viewport = varied(vary, written);
        out.append("matrix", ask<viewport_matrix>(out, viewport));
        const glm::vec3 low(viewport.left, viewport.bottom, viewport.near_depth);
        const glm::vec3 size(viewport.width, viewport.height, viewport.far_depth - viewport.near_depth);
        for (const glm::vec3& share : {glm::vec3(0), glm::vec3(0.5F), glm::vec3(1), {0.25F, 0.75F, 1}})
            out.append("back", ask<ndc_from_window>(out, viewport, low + vary.near(share, 0.1F) * size));
    }
}

// Pixels of a window of 8 x 4 pixels, whose borders are floats, and of one that lies elsewhere.
void record_known_pixels(Variation& vary, Recorder& out)
{
    const std::array powers{16, 32};
    const Viewport small{vary.near(0, 20), vary.near(0, 20), vary.one_of(8, powers), vary.one_of(4, powers)};
    for (const glm::vec2& ndc : {glm::vec2(-1, -1),
                                 {-0.9F, -0.9F},
                                 {0, 0},
                                 {-0.01F, 0.01F},
                                 {0.99F, 0.99F},
                                 {0.24F, 0.51F},
                                 {0.25F, 0.5F},
                                 {-0.75F, -0.5F},
                                 {-0.8F, 0.3F}})
        record_pixel(out, small, ndc);
    const Viewport moved{vary.near(100, 30), vary.near(-7, 30), vary.one_of(5, std::array{7, 9, 11}),
                         vary.one_of(3, std::array{5, 7, 9})};
    for (const glm::vec2& ndc : {glm::vec2(-1, -1), {0, 0}, {0.9F, 0.9F}, {-0.5F, 0.4F}, {0.3F, -0.4F}})
        record_pixel(out, moved, ndc);
    for (const Viewport& viewport : {small, moved})
        for (const glm::ivec2& place : {glm::ivec2(0, 0), {1, 2}, {4, 2}, {7, 3}, {-1, 0}, {3, 9}})
            out.append("centre", ask<pixel_centre>(out, viewport, glm::ivec2(viewport.left, viewport.bottom) + place));
}

int random_between(int low, int high, Random& random)
{
    return low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1)));
}

// Mostly a window's; now and then as wide or as high as a poster's, of which parts are drawn one by one.
int random_size(Random& random)
{
    return random.below(8) == 0 ? random_between(40'000, 1 << 20, random) : random_between(20, 900, random);
}

// Anywhere in the window or outside it; depths in [0, 1], or of any other range, now and then a very small one.
Viewport random_viewport(Random& random)
{
    const int left = random_between(-500, 500, random);
    const int bottom = random_between(-500, 500, random);
    const int width = random_size(random);
    const int height = random_size(random);
    const float stretch = random.below(2) == 0 ? 4.0F : 1.0F;
    const float near_depth = random.uniform(0, 0.45F) * stretch - (stretch - 1) / 2;
    const float far_depth = random.uniform(0.55F, 1) * stretch - (stretch - 1) / 2;
    const bool reversed = random.below(4) == 0;
    const float unit = random.below(3) == 0 ? std::ldexp(1.0F, -20 - static_cast<int>(random.below(20))) : 1.0F;
    return {left,
            bottom,
            width,
            height,
            unit * (reversed ? far_depth : near_depth),
            unit * (reversed ? near_depth : far_depth)};
}

// The inner 80 % of a pixel of the viewport, counted from its corner: no rounding leads out of it.
glm::vec2 place_in(const Viewport& viewport, const glm::ivec2& pixel, Random& random)
{
    const glm::vec2 aside(0.4F * random.uniform(-1, 1), 0.4F * random.uniform(-1, 1));
    const glm::dvec2 share =
        (glm::dvec2(pixel) + 0.5 + glm::dvec2(aside)) / glm::dvec2(viewport.width, viewport.height);
    return glm::vec2(2.0 * share - 1.0);
}

void record_at_random(const Viewport& viewport, int i, Random& random, Recorder& out)
{
    out.append("matrix", ask<viewport_matrix>(out, viewport));
    const float x = random.uniform(-0.2F, 1.2F);
    const float y = random.uniform(-0.2F, 1.2F);
    const glm::vec2 place =
        glm::vec2(viewport.left, viewport.bottom) + glm::vec2(x, y) * glm::vec2(viewport.width, viewport.height);
    const float depth = glm::mix(viewport.near_depth, viewport.far_depth, random.uniform(-0.2F, 1.2F));
    out.append("back", ask<ndc_from_window>(out, viewport, glm::vec3(place, depth)));
    const int column = random_between(0, viewport.width - 1, random);
    const glm::ivec2 pixel(column, random_between(0, viewport.height - 1, random));
    record_pixel(out, viewport, place_in(viewport, pixel, random));
    // Half of them lie outside the viewport, on either side.
    const glm::ivec2 size(viewport.width, viewport.height);
    const glm::ivec2 aside = i % 2 == 0 ? glm::ivec2(0) : (i % 4 == 1 ? 1 : -1) * size / (1 + i % 3);
    const glm::ivec2 in_window = pixel + aside + glm::ivec2(viewport.left, viewport.bottom);
    out.append("centre", ask<pixel_centre>(out, viewport, in_window));
    if (i % 4 != 0) return;
    // The same pixel, and the same place, of the window with the viewport beside.
    Viewport beside = viewport;
    beside.left += 1 + viewport.width / 3;
    beside.bottom -= viewport.height / 2;
    out.append("centre", ask<pixel_centre>(out, beside, in_window));
    out.append("back", ask<ndc_from_window>(out, viewport, glm::vec3(place, depth)));
    out.append("back", ask<ndc_from_window>(out, beside, glm::vec3(place, depth)));
}

// Every second one is the one before in another place, of another size or with other depths: whoever remembers what was
// asked before has to look at all of it.
void record_random(Random& random, Recorder& out)
{
    Viewport viewport{};
    for (int i = 0; i < 150; ++i) {
        const Viewport fresh = random_viewport(random);
        if (i % 2 == 0)
            viewport = fresh;
        else if (i % 3 == 0)
            std::tie(viewport.left, viewport.bottom) = std::tie(fresh.left, fresh.bottom);
        else if (i % 3 == 1)
            std::tie(viewport.width, viewport.height) = std::tie(fresh.width, fresh.height);
        else
            std::tie(viewport.near_depth, viewport.far_depth) = std::tie(fresh.near_depth, fresh.far_depth);
        record_at_random(viewport, i, random, out);
    }
}

// A point of the viewport, every third one on its left or lower border, and one outside or on its right or upper
// border, in random order.
void record_outside(Random& random, Recorder& out)
{
    constexpr float no_number = std::numeric_limits<float>::quiet_NaN();
    for (int i = 0; i < 56; ++i) {
        const Viewport viewport = random_viewport(random);
        const int column = random_between(0, viewport.width - 1, random);
        const glm::ivec2 pixel(column, random_between(0, viewport.height - 1, random));
        glm::vec2 inside = place_in(viewport, pixel, random);
        if (i % 3 == 2) inside[i / 3 % 2] = -1;
        glm::vec2 outside = inside;
        const float above = 1.0F + random.uniform(0.01F, 2);
        const float below = -1.0F - random.uniform(0.01F, 2);
        const float beyond[] = {1, above, below, -1.0000001F, 1e30F, no_number, no_number};
        outside[i % 2] = beyond[i / 2 % 7];
        const bool first = random.below(2) == 1;
        for (const bool is_outside : {first, !first}) record_pixel(out, viewport, is_outside ? outside : inside);
    }
}

/// What a viewport has along one of its axes, and a place there.
struct AlongAxis {
    int corner;
    int size;
    float ndc;
};

/// A viewport whose middle is a border between pixels, at any place in a window; and a place beside that border, so
/// near that the place with the corner added to it is on the border, in double too.
AlongAxis beside_middle(int i, Random& random)
{
    const int far = i % 12 == 5 ? (1 << 22) - 10'000 : 1000;
    const int corner = random_between(-far, far, random);
    const int size = 2 * random_between(250, 4000, random);
    // Multiples of the last place of a double below 1: with 1 added nothing is rounded.
    const float aside = std::ldexp(random.uniform(0.5F, 1), -36 - static_cast<int>(random.below(16)));
    const float x = 0x1p-53F * std::round(aside / 0x1p-53F);
    return {corner, size, random.below(4) == 0 ? 2 * x : -x};
}

/// One of the floats on both sides of a border between pixels, or the last one before 1. Half of the borders lie near
/// the middle, where floats are finest; a sixth of them in the middle itself.
AlongAxis beside_border(int i, Random& random)
{
    if (i % 6 == 5) return beside_middle(i, random);
    const int corner = random_between(-1000, 1000, random);
    const int size = random_between(500, 8000, random);
    const int border =
        i % 2 == 0 ? random_between(1, size - 1, random) : random_between(size / 2 - 8, size / 2 + 8, random);
    auto x = static_cast<float>((2.0 * border - size) / size);
    if (i % 3 == 0) x = std::nextafter(x, -2.0F);
    if (i % 3 == 1) x = std::nextafter(x, 2.0F);
    if (i % 10 == 8) x = std::nextafter(1.0F, 0.0F);
    return {corner, size, std::abs(x) < 1e-4F ? 0.3F : x};
}

// Columns and rows, of corners that are not those of the window.
void record_beside_borders(Random& random, Recorder& out)
{
    for (int i = 0; i < 300; ++i) {
        const AlongAxis x = beside_border(i, random);
        const AlongAxis y = beside_border(i / 3 + 7 * i, random);
        record_pixel(out, {x.corner, y.corner, x.size, y.size}, {x.ndc, y.ndc});
    }
}

/// Nearly as large as floats are, of two signs or of either one, so that their difference or their sum is none; or so
/// small that their difference is 1e-12 … 1e-30.
glm::vec2 extreme_depths(int kind, Random& random)
{
    constexpr float largest = std::numeric_limits<float>::max();
    if (kind == 0) return largest * glm::vec2(-random.uniform(0.6F, 1), random.uniform(0.6F, 1));
    const float sign = random.below(2) == 0 ? 1.0F : -1.0F;
    if (kind == 1) return sign * largest * glm::vec2(random.uniform(0.5F, 0.7F), random.uniform(0.8F, 1));
    const float unit = std::ldexp(1.0F, -42 - static_cast<int>(random.below(60)));
    return unit * glm::vec2(random.uniform(-1, 0.4F), random.uniform(0.6F, 1));
}

// A few pixels as far from the window's corner as the interface allows; and depths of any range, in either order.
void record_extremes(Random& random, Recorder& out)
{
    constexpr int far = (1 << 22) - 1000;
    for (int i = 0; i < 80; ++i) {
        Viewport viewport = random_viewport(random);
        viewport.width = random_between(5, 900, random);
        viewport.height = random_between(5, 900, random);
        if (i % 2 == 0) viewport.left = (i % 4 == 0 ? -1 : 1) * random_between(far / 2, far, random);
        if (i % 4 < 2) viewport.bottom = random_between(-far, far, random);
        const glm::vec2 depths = extreme_depths(i % 3, random);
        const auto first = static_cast<int>(random.below(2));
        if (i % 4 > 0) viewport.near_depth = depths[first], viewport.far_depth = depths[1 - first];
        out.append("matrix", ask<viewport_matrix>(out, viewport));
        const glm::dvec3 low(viewport.left, viewport.bottom, viewport.near_depth);
        const glm::dvec3 high = low + glm::dvec3(viewport.width, viewport.height, viewport.far_depth - low.z);
        const glm::dvec3 share(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        out.append("back", ask<ndc_from_window>(out, viewport, glm::vec3(glm::mix(low, high, share))));
    }
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"known pixels", [](Case& c, Recorder& out) { record_known_pixels(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"outside", [](Case& c, Recorder& out) { record_outside(c.random, out); }},
    {"beside borders", [](Case& c, Recorder& out) { record_beside_borders(c.random, out); }},
    {"extremes", [](Case& c, Recorder& out) { record_extremes(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_flowers(out, c.vary)); }},
};

}
