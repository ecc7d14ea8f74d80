#pragma once

#include <algorithm>
#include <cmath>
#include <kit/channels.hpp>
#include <limits>
#include <umbral/core/random.hpp>
#include <umbral/raytracing/transparent_z_buffer.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/not_finite.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// Fragments for raytracing/transparent-z-buffer.
namespace umbral::raytracing {

/// A frame as it is before, and what is drawn into it.
struct GlassTask {
    GlassFrame frame;
    std::vector<GlassFragment> glass = {};
    std::vector<OpaqueFragment> opaque = {};
};

inline glm::vec3 random_light(Random& random, float most)
{
    const float red = random.uniform(0, most);
    const float green = random.uniform(0, most);
    return {red, green, random.uniform(0, most)};
}

/// The same, but of four one has a single channel, or lacks one.
inline glm::vec3 random_tint(Random& random, float most)
{
    const glm::vec3 light = random_light(random, most);
    return random.below(4) == 0 ? some_channels(random, light) : light;
}

/// Light and depths at random; a quarter of the pixels is empty, and one in eight far brighter than the others.
inline GlassFrame random_frame(Random& random)
{
    const int width = 2 + static_cast<int>(random.below(5));
    const int height = 1 + static_cast<int>(random.below(4));
    GlassFrame frame{Grid<glm::vec3>(width, height), Grid<float>(width, height)};
    for (glm::vec3& light : frame.light.cells) light = random_tint(random, random.below(8) == 0 ? 3000.0F : 3.0F);
    for (float& depth : frame.depths.cells)
        depth = random.below(4) == 0 ? std::numeric_limits<float>::infinity() : random.uniform(0.5F, 1);
    return frame;
}

/// A place of the frame; one in ten lies beside it.
inline glm::ivec2 random_pixel(Random& random, const GlassFrame& frame)
{
    const int border = random.below(10) == 0 ? 2 : 0;
    const auto along = [&](int size) {
        return static_cast<int>(random.below(static_cast<std::uint32_t>(size + 2 * border))) - border;
    };
    const int x = along(frame.light.width);
    return {x, along(frame.light.height)};
}

/// A depth of one of a hundred steps or one float behind it, so that many are alike, or nearly; some far beyond; some
/// exactly what the frame has, or one float before or behind that; or no number.
inline float random_depth(Random& random, const GlassFrame& frame, const glm::ivec2& pixel)
{
    constexpr float endless = std::numeric_limits<float>::infinity();
    const std::uint32_t kind = random.below(20);
    const float step = static_cast<float>(random.below(100)) / 100;
    const float beside = random.below(2) == 0 ? -endless : endless;
    if (kind == 0) return std::numeric_limits<float>::quiet_NaN();
    if (kind == 1) return endless;
    if (kind == 2) return random.below(3) == 0 ? -endless : -step;
    if (kind == 3) return 1000 * step;
    if (kind <= 7 && frame.depths.contains(pixel.x, pixel.y)) {
        const float there = frame.depths.at(pixel.x, pixel.y);
        return kind <= 5 ? there : std::nextafter(there, beside);
    }
    return kind < 12 ? std::nextafter(step, endless) : step;
}

inline GlassFragment random_glass(Random& random, const GlassFrame& frame)
{
    GlassFragment fragment;
    fragment.pixel = random_pixel(random, frame);
    fragment.depth = random_depth(random, frame, fragment.pixel);
    fragment.light = random_tint(random, random.below(8) == 0 ? 0.0F : 2.0F);
    fragment.k_t = random.uniform(0.2F, 1);
    fragment.m_t = random_tint(random, 1);
    // What lets nothing through, and what is quite clear.
    const std::uint32_t kind = random.below(16);
    if (kind < 4) fragment.k_t = kind < 2 ? 0.0F : 1.0F;
    if (kind == 3 || kind == 4) fragment.m_t = glm::vec3(1);
    return fragment;
}

/// Up to 39 fragments, of six lists one or two; of eight fragments one is the same as the one before, in all it has.
inline GlassTask random_task(Random& random)
{
    GlassTask task{random_frame(random)};
    const std::uint32_t count = random.below(6) == 0 ? 1 + random.below(2) : random.below(40);
    for (std::uint32_t i = 0; i < count; ++i) {
        const bool again = i > 0 && random.below(8) == 0;
        task.glass.push_back(again ? task.glass.back() : random_glass(random, task.frame));
        const GlassFragment& like = task.glass.back();
        task.opaque.push_back({like.pixel, like.depth, like.light});
    }
    return task;
}

/// Hundreds of sheets in few pixels, nearly clear, in no order; every fourth at the depth of another one, and as many
/// one float behind another one.
inline GlassTask deep_task(Random& random)
{
    GlassTask task{{Grid<glm::vec3>(2, 1, glm::vec3(1, 2, 3)), Grid<float>(2, 1, 1.0F)}};
    for (int i = 0; i < 400; ++i) {
        GlassFragment sheet;
        sheet.pixel = {i % 2, 0};
        sheet.depth = static_cast<float>(random.below(300)) / 300;
        if (random.below(2) == 0) sheet.depth = std::nextafter(sheet.depth, 2.0F);
        sheet.light = random_light(random, 0.1F);
        sheet.k_t = random.uniform(0.95F, 1);
        sheet.m_t = glm::vec3(1) - random_light(random, 0.05F);
        task.glass.push_back(sheet);
    }
    return task;
}

/// Three sheets before a background, in one pixel each, in all six orders: x is behind y, and y behind z.
inline GlassTask three_sheets(Variation& vary)
{
    std::vector<GlassFragment> sheets = {
        {{0, 0}, 0.75F, {0, 0, 0.25F}, 0.5F, {1, 0, 0.5F}},
        {{0, 0}, 0.5F, {0.125F, 0, 0}, 1, {0.5F, 0.5F, 1}},
        {{0, 0}, 0.25F, {0, 0.5F, 0}, 0.75F, {1, 0.5F, 0.25F}},
    };
    for (GlassFragment& sheet : sheets) {
        sheet.light *= vary.one_of(1.0F, std::array{0.5F, 0.75F, 1.25F, 1.5F});
        sheet.m_t *= vary.one_of(1.0F, std::array{0.5F, 0.625F, 0.75F, 0.875F});
    }
    GlassTask task{{Grid<glm::vec3>(8, 1, glm::vec3(1)), Grid<float>(8, 1, 1.0F)}};
    std::vector<std::size_t> order = {0, 1, 2};
    int pixel = 0;
    do {
        for (const std::size_t i : order) {
            task.glass.push_back(sheets[i]);
            task.glass.back().pixel.x = pixel;
        }
        ++pixel;
    } while (std::next_permutation(order.begin(), order.end()));
    // And with something opaque between them; the last pixel has none.
    for (const GlassFragment& sheet : sheets) {
        task.glass.push_back(sheet);
        task.glass.back().pixel.x = 6;
    }
    task.frame.depths.at(6, 0) = 0.5F;
    task.frame.light.at(6, 0) = {0.5F, 2, 4};
    return task;
}

/// A row for each cell: its light and its depth. NaN if the frame has another size than it had.
inline std::vector<glm::vec4> rows_of(const GlassFrame& frame, int width, int height)
{
    const auto cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const bool is_whole = frame.light.width == width && frame.light.height == height && frame.depths.width == width &&
                          frame.depths.height == height && frame.light.cells.size() == cells &&
                          frame.depths.cells.size() == cells;
    std::vector<glm::vec4> rows(cells, glm::vec4(std::numeric_limits<float>::quiet_NaN()));
    for (std::size_t i = 0; is_whole && i < cells; ++i) {
        rows[i] = glm::vec4(frame.light.cells[i], recordable(frame.depths.cells[i]));
    }
    return rows;
}

inline void record_frame(Recorder& out, const GlassFrame& frame, int width, int height)
{
    for (const glm::vec4& row : rows_of(frame, width, height)) {
        out.append("light", glm::vec3(row));
        out.append("depths", row.w);
    }
}

}
