#include <array>
#include <kit/numbers_changed.hpp>
#include <kit/refusal.hpp>
#include <limits>
#include <umbral/record/driver.hpp>

#include "scene.hpp"

namespace umbral {
namespace {

using namespace texturing;

// How many levels there are and how large each is, then their texels, level by level and row by row: as many as there
// should be, and of level 0, which is the texture itself, the first and the last.
void record_mipmap(Recorder& out, const Grid<glm::vec4>& texture)
{
    const Mipmap mipmap = ask<build_mipmap>(out, texture);
    out.columns("sizes", "columns (first row: levels), rows (first row: 0)");
    out.columns("texels", "red, green, blue, alpha");
    out.append("sizes", glm::vec2(mipmap.size(), 0));
    std::size_t level = 0;
    for (int size = texture.width; size >= 1; size /= 2, ++level) {
        const bool exists = level < mipmap.size() && mipmap[level].width == size && mipmap[level].height == size &&
                            mipmap[level].cells.size() == static_cast<std::size_t>(size * size);
        out.append("sizes",
                   level < mipmap.size() ? glm::vec2(mipmap[level].width, mipmap[level].height) : glm::vec2(-1));
        for (int i = 0; i < size * size; i += level == 0 ? std::max(1, size * size - 1) : 1)
            out.append("texels",
                       exists ? std::optional(mipmap[level].cells[static_cast<std::size_t>(i)]) : std::nullopt);
    }
}

// Greys in quarters, whose means are exact; (r, g, b, a) differ, and none is a mean of two of its neighbours. Varied,
// all texels are darker or brighter.
Grid<glm::vec4> small_texture(Variation& vary, int size)
{
    const glm::ivec4 first = vary.near(glm::ivec4(0), 3);
    Grid<glm::vec4> texture(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            texture.at(x, y) = glm::vec4(first + glm::ivec4((x + 3 * x * y) % 7, y * (x + 1) % 5, x * y % 3,
                                                            (x * y + x + 2 * y) % 5)) /
                               4.0F;
    return texture;
}

// Four levels, each of one grey, so that a blend tells which levels it took and with what weight. Varied, the greys are
// others.
Mipmap grey_levels(Variation& vary)
{
    Mipmap mipmap;
    const int step = vary.one_of(2, std::array{-2, 1, 3});
    int quarters = vary.near(0, 2);
    for (const int size : {8, 4, 2, 1}) {
        mipmap.emplace_back(size, size, glm::vec4(static_cast<float>(quarters) / 4));
        quarters += step;
    }
    return mipmap;
}

// From `size` down to `smallest`: a mipmap need not be complete.
Mipmap random_mipmap(Random& random, int size, int smallest)
{
    Mipmap mipmap;
    for (; size >= smallest; size /= 2) mipmap.push_back(random_texture(random, size, size));
    return mipmap;
}

void by_hand(Variation& vary, Recorder& out)
{
    for (const int size : {1, 2, 4, 8}) record_mipmap(out, small_texture(vary, size));
    for (const float distance : {1.0F, 2.0F, 4.0F, 3.0F, 6.0F, 0.5F, 64.0F, 2.5F})
        out.append("distances", ask<level_at_distance>(out, vary.scaled(distance, 1.3F), 2));
    const glm::vec2 steps[][2] = {{{0.125F, 0}, {0, 0.125F}}, {{0.25F, 0}, {0, 0.125F}},  {{0, 0.25F}, {0.5F, 0}},
                                  {{0.75F, 1}, {0, 0}},       {{0.0625F, 0}, {0, 0.03F}}, {{0, 0}, {0, 0}},
                                  {{-0.5F, 0}, {0, 0.25F}},   {{0, 0}, {-0.3F, -0.4F}}};
    for (const auto& [by_x, by_y] : steps)
        for (const glm::ivec2 size : {glm::ivec2(8, 8), {16, 4}}) {
            const float longer = vary.scaled(1.0F, 1.4F);
            out.append("steps", ask<level_of_step>(out, longer * by_x, longer * by_y, size));
        }
    const Mipmap greys = grey_levels(vary);
    for (const float level : {0.0F, 1.0F, 2.0F, 3.0F, 0.5F, 1.25F, 2.75F, -0.5F, -3.0F, 3.25F, 9.0F})
        out.append("blends", ask<trilinear>(out, greys, {0.3F, 0.6F}, level));
    // Two levels of four: the last one need not have a single texel.
    const Mipmap two(greys.begin(), greys.begin() + 2);
    for (const float level : {0.75F, 1.0F, 1.5F, 3.0F})
        out.append("blends", ask<trilinear>(out, two, {0.3F, 0.6F}, level));
    // Places outside the unit square, and blends across its border.
    const Mipmap pattern = {small_texture(vary, 4), small_texture(vary, 2)};
    for (const glm::vec2 uv : {glm::vec2(1.375F, -0.375F), {-0.125F, 0.625F}, {0, 1}, {0.5F, 2.75F}})
        for (const float level : {0.0F, 0.5F, 1.0F}) out.append("blends", ask<trilinear>(out, pattern, uv, level));
}

void textures(Random& random, Recorder& out)
{
    for (const int size : {2, 8, 16}) record_mipmap(out, random_texture(random, size, size));
    // Light, and what is no colour: numbers above 1 and below 0.
    for (const int size : {4, 32}) {
        Grid<glm::vec4> texture = random_texture(random, size, size);
        for (glm::vec4& texel : texture.cells) texel = 8.0F * texel - 4.0F;
        record_mipmap(out, texture);
        // As large as the one before, with one channel that is 0, or of one colour.
        texture = random_texture(random, size, size);
        const auto channel = static_cast<glm::length_t>(random.below(4));
        for (glm::vec4& texel : texture.cells) texel[channel] = 0;
        record_mipmap(out, texture);
        record_mipmap(out, Grid<glm::vec4>(size, size, texture.at(1, 0)));
    }
    record_mipmap(out, random_texture(random, 1, 1));
}

void record_refusals(Random& random, Recorder& out)
{
    for (const glm::ivec2 size : {glm::ivec2(3, 3), {4, 2}, {1, 2}, {2, 1}, {6, 6}, {0, 0}, {12, 12}, {8, 7}}) {
        const int good = 1 << random.below(4);
        const bool good_first = random.below(2) == 0;
        for (const bool is_good : {good_first, !good_first})
            record_refusal(out, "refused", [&] {
                return ask<build_mipmap>(out, is_good ? Grid<glm::vec4>(good, good) : Grid<glm::vec4>(size.x, size.y));
            });
    }
}

glm::vec2 random_step(Random& random, float low, float high)
{
    const float angle = random.uniform(0, 6.28F);
    return std::exp2(random.uniform(low, high)) * glm::vec2(std::cos(angle), std::sin(angle));
}

void levels(Random& random, Recorder& out)
{
    for (int i = 0; i < 300; ++i) {
        const float near = random.uniform(0.2F, 8);
        out.append("distances", ask<level_at_distance>(out, near * std::exp2(random.uniform(-3, 9)), near));
        const glm::ivec2 size(1 << (3 + random.below(7)), 1 << (3 + random.below(7)));
        const glm::vec2 by_x = random_step(random, -11, -1);
        // In half of the cases as long in (u, v) as the other one, or nearly so: then the size decides.
        const glm::vec2 by_y =
            i % 2 == 0 ? random_step(random, -11, -1) : random.uniform(0.5F, 2) * glm::vec2(by_x.y, -by_x.x);
        out.append("steps", ask<level_of_step>(out, by_x, by_y, size));
    }
}

// Both ways in which a question differs from the one before in one number only; steps with a coordinate that is 0, or
// equal to the other, or of the same length; textures of one texel, row or column.
void changed_levels(Random& random, Recorder& out)
{
    using Distances = std::pair<float, float>;
    using Steps = std::pair<glm::vec2, glm::vec2>;
    const auto is_positive = [](const Distances& d) { return d.first > 0 && d.second > 0; };
    for (int i = 0; i < 20; ++i) {
        const float near = random.uniform(0.2F, 2);
        for (const auto& [distance, one] : numbers_changed(random, Distances(3 * near, near), 2, is_positive))
            out.append("distances", ask<level_at_distance>(out, distance, one));
        // Further and further from the same place, and then nearer.
        for (const float away : {random.uniform(1.1F, 2), random.uniform(2.5F, 9), random.uniform(0.1F, 0.9F), 1.0F})
            out.append("distances", ask<level_at_distance>(out, near * away, near));

        glm::ivec2 size(1 << (3 + random.below(7)), 1 << (3 + random.below(7)));
        const Steps steps(random_step(random, -4, 0), random_step(random, -4, 0));
        for (const auto& [by_x, by_y] : numbers_changed(random, steps, 4)) {
            out.append("steps", ask<level_of_step>(out, by_x, by_y, size));
            if (i % 4 == 0) out.append("steps", ask<level_of_step>(out, by_x, by_x, size));
            size[i % 2] = size[i % 2] == 1 ? 64 : size[i % 2] / 2;
            out.append("steps", ask<level_of_step>(out, by_x, by_y, size));
        }
        const float step = random.uniform(1.5F, 40);
        size = i % 2 == 0 ? glm::ivec2(1, 256) : glm::ivec2(256, 1);
        out.append("steps", ask<level_of_step>(out, step * steps.first, glm::vec2(step, 0), size));
        out.append("steps", ask<level_of_step>(out, glm::vec2(0, step), glm::vec2(0), glm::ivec2(1)));
    }
}

// The same texels but for one level of the mipmap, at the same place; then another place; then another level. One
// coordinate is 0, or both are equal; all levels are of one colour.
void changed_blends(Random& random, Recorder& out)
{
    for (int i = 0; i < 24; ++i) {
        Mipmap mipmap = random_mipmap(random, 8, 1 << random.below(3));
        glm::vec2 uv(random.uniform(-2, 2), random.uniform(-2, 2));
        if (i % 4 < 2) uv[i % 2] = 0;
        if (i % 4 == 2) uv.y = uv.x;
        const float last = static_cast<float>(mipmap.size() - 1);
        const float level = random.uniform(0.05F, last == 0 ? 0.95F : last - 0.05F);
        const char* const value = level < last ? "between" : "ends";
        out.append(value, ask<trilinear>(out, mipmap, uv, level));
        for (Grid<glm::vec4>& changed : mipmap) {
            changed = random_texture(random, changed.width, changed.height);
            out.append(value, ask<trilinear>(out, mipmap, uv, level));
        }
        uv[i % 2] += random.uniform(0.1F, 0.4F);
        out.append(value, ask<trilinear>(out, mipmap, uv, level));
        out.append("ends", ask<trilinear>(out, mipmap, uv, random.below(2) == 0 ? 0 : last));
        out.append("ends", ask<trilinear>(out, {mipmap.front()}, uv, level));
    }
}

// Places up to two turns outside, levels between, on, below and above those that there are.
void blends(Random& random, Recorder& out)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const Mipmap mipmaps[] = {random_mipmap(random, 16, 1), random_mipmap(random, 4, 1), random_mipmap(random, 1, 1),
                              random_mipmap(random, 16, 4), random_mipmap(random, 8, 8)};
    for (int i = 0; i < 400; ++i) {
        const Mipmap& mipmap = mipmaps[i % 8 == 0 ? 2 + random.below(3) : random.below(2)];
        const float u = random.uniform(-2, 2);
        const glm::vec2 uv(u, random.uniform(-2, 2));
        out.append("between", ask<trilinear>(out, mipmap, uv, random.uniform(0.05F, 3.95F)));
    }
    for (int i = 0; i < 200; ++i) {
        const Mipmap& mipmap = mipmaps[random.below(5)];
        const float u = random.uniform(-2, 2);
        const glm::vec2 uv(u, random.uniform(-2, 2));
        const float last = static_cast<float>(mipmap.size() - 1);
        const float past[] = {
            -random.uniform(0, 3), last + random.uniform(0, 3), last, 0, -1e6F, 1e9F, -infinity, infinity};
        out.append("ends", ask<trilinear>(out, mipmap, uv, past[random.below(8)]));
    }
}

// Quotients and squares that overflow or vanish in float.
void extreme(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        const float far = std::exp2(random.uniform(70, 126));
        const float near = std::exp2(random.uniform(-126, -70));
        out.append("distances",
                   i % 4 == 0 ? ask<level_at_distance>(out, near, far) : ask<level_at_distance>(out, far, near));
        const bool tiny = i % 4 == 0;
        const glm::vec2 by_x = random_step(random, tiny ? -120.0F : 60.0F, tiny ? -70.0F : 110.0F);
        out.append("steps", ask<level_of_step>(out, by_x, random_step(random, -10, 60), {1024, 16}));
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"textures", [](Case& c, Recorder& out) { textures(c.random, out); }},
    {"refused", [](Case& c, Recorder& out) { record_refusals(c.random, out); }},
    {"levels",
     [](Case& c, Recorder& out) {
         levels(c.random, out);
         changed_levels(c.random, out);
     }},
    {"blends",
     [](Case& c, Recorder& out) {
         blends(c.random, out);
         changed_blends(c.random, out);
     }},
    {"extreme", [](Case& c, Recorder& out) { extreme(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", picture(out, 480, 300, c.vary)); }},
};

}
