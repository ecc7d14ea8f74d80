#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <umbral/core/grid.hpp>
#include <umbral/core/random.hpp>
#include <umbral/pipeline/depth.hpp>
#include <umbral/record/ask.hpp>

/// Depths for pipeline/depth-buffer: the codes of a format, and what lies close to them.
namespace umbral::pipeline {

inline float last_code(DepthFormat format) { return format == DepthFormat::unorm16 ? 65535.0F : 16777215.0F; }

/// A code, and the float that is stored for it: nothing if that is more than two ulp from it.
struct Code {
    double number;
    std::optional<float> stored;
};

/// The code nearest to a depth, behind its neighbours: a function that stores all depths alike has not found it.
inline std::array<Code, 3> codes_around(Recorder& out, DepthFormat format, float depth)
{
    const double last = last_code(format);
    const double nearest = std::nearbyint(depth * last);
    const auto code = [&](double number) {
        const double exact = number / last;
        const float stored = ask<stored_depth>(out, format, static_cast<float>(exact));
        const bool near = std::abs(stored - exact) <= std::ldexp(exact, -22);
        return Code{number, near ? std::optional(stored) : std::nullopt};
    };
    return {code(nearest - 1), code(nearest + 1), code(nearest)};
}

/// A depth of any size: anywhere, or a few ulps beside the middle between two codes.
inline float depth_for_code(Random& random, DepthFormat format)
{
    const float depth = std::exp2(-8 * random.uniform() * random.uniform());
    if (random.below(2) == 0) return depth;
    const double last = last_code(format);
    auto beside = static_cast<float>((std::floor(depth * last) - 0.5) / last);
    const float towards = static_cast<float>(random.below(2));
    for (std::uint32_t ulps = random.below(4); ulps > 0; --ulps) beside = std::nextafter(beside, towards);
    return beside;
}

/// Depths of all sizes, and what is kept of them, which stays as it is; not where two ulp are a code of 24 bits. What
/// comes back is recorded as the code that is stored so, -1 if none around is: an ulp beside the nearest float, a code
/// of 24 bits may lie at its neighbour's.
inline void record_codes(Random& random, Recorder& out)
{
    for (int i = 0; i < 400; ++i) {
        const DepthFormat format = i % 3 == 0 ? DepthFormat::unorm16 : DepthFormat::unorm24;
        float depth = depth_for_code(random, format);
        const std::array<Code, 3> codes = codes_around(out, format, depth);
        const int times = format == DepthFormat::unorm16 || depth < 0.25F ? 2 : 1;
        for (int time = 0; time < times; ++time) {
            depth = ask<stored_depth>(out, format, depth);
            const auto found = std::ranges::find(codes, depth, &Code::stored);
            out.append("code", found == codes.end() ? -1 : found->number);
        }
    }
}

/// Columns and rows of the small buffers; not square.
inline constexpr int tile_width = 7;
inline constexpr int tile_height = 5;

/// Codes and what lies between them. 24 bits are wider than a float's steps only below 1/4.
struct Levels {
    DepthFormat format;
    std::uint32_t first;

    [[nodiscard]] float at(double offset) const { return static_cast<float>((first + offset) / last_code(format)); }
};

/// One time in four at an end, where depths lie beyond [0, 1] too: next to 0, or next to 1, as in a cleared buffer.
/// (The last codes of 24 bits are too close for floats.)
inline Levels random_levels(Random& random, DepthFormat format)
{
    const std::uint32_t first = 1000 + random.below(format == DepthFormat::unorm16 ? 60'000 : 1'000'000);
    const std::uint32_t end = random.below(8);
    if (end == 0) return {format, 0};
    if (end == 1 && format != DepthFormat::unorm24) return {format, static_cast<std::uint32_t>(last_code(format))};
    return {format, first};
}

/// A depth within two codes of the first one, never halfway between two; at an end sometimes far beyond it.
inline float random_depth(Random& random, const Levels& levels)
{
    const float far = std::exp2(random.uniform(-10, 40));
    if (const float end = levels.at(0); (end == 0 || end == 1) && random.below(4) == 0)
        return end == 0 ? -far : 1 + far;
    constexpr std::array offsets = {-1.3, -1.0, -0.7, -0.3, 0.0, 0.3, 0.7, 1.0, 1.3};
    return levels.at(offsets[random.below(static_cast<std::uint32_t>(offsets.size()))]);
}

/// A buffer of codes that the format has, all close together, so that ties occur: as the unit itself keeps them, since
/// the last bit of these floats is free. Floats lie between codes, too.
inline Grid<float> random_depths(Random& random, Recorder& out, const Levels& levels)
{
    Grid<float> depths(tile_width, tile_height);
    const double beside = levels.format == DepthFormat::float32 ? 0.3 : 0;
    for (float& depth : depths.cells)
        depth = ask<stored_depth>(out, levels.format, levels.at(static_cast<double>(random.below(3)) - 1 + beside));
    return depths;
}

}
