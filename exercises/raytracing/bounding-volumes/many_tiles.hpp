#pragma once

#include <memory>
#include <string>
#include <umbral/raytracing/bounding_volumes.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "soups.hpp"

namespace umbral::raytracing {

/// More triangles than 16 bits count: tiles that lie apart, each seen by a ray of its own from above. Rays are asked
/// again when exactly 256 questions have gone by, most of them about other tiles: what a hierarchy notes of its
/// triangles while it is asked must not be taken for a later ray's.
inline void many(Recorder& out, Random& random)
{
    constexpr std::uint32_t in_a_row = 257;
    Soup tiles;
    for (std::uint32_t i = 0; i < in_a_row * in_a_row; ++i) {
        const glm::vec3 corner(i % in_a_row, i / in_a_row, 0);
        tiles.push_back({corner, corner + glm::vec3(0.75F, 0, 0), corner + glm::vec3(0, 0.75F, 0)});
    }
    const std::unique_ptr<TriangleHierarchy> hierarchy = make_triangle_hierarchy(tiles);
    constexpr std::size_t recorded = 32;
    std::vector<Ray> rays;
    for (std::uint32_t i = 0; i < 256; ++i) {
        const bool is_late = i < recorded && i % 2 == 0;
        const std::uint32_t tile = is_late ? 0xFFFF + random.below(in_a_row + 2) : random.below(0xFFFF);
        rays.push_back({tiles[tile].v0 + glm::vec3(0.25F, 0.25F, 3), {0, 0, -1}});
    }
    const auto ask_for = [&](std::size_t i, bool again) {
        ask_in_words(out, [&] {
            const std::string row = std::to_string(in_a_row);
            return "// " + std::to_string(tiles.size()) + " triangles; number i has its right angle at (i % " + row +
                   ", i / " + row + ", 0), and legs 0.75 long along +x and +y\n" +
                   (again ? "// asked for the second time: 256 rays ago it was this one too\n" : "") +
                   "hierarchy->first_hit(" + literal::of_value(rays[i], true, {}) + ");";
        });
        return hierarchy ? hierarchy->first_hit(rays[i]) : std::nullopt;
    };
    for (const bool again : {false, true})
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const std::optional<FirstTriangle> first = ask_for(i, again);
            if (i >= recorded) continue;
            out.append("index", first ? std::optional(static_cast<float>(first->index)) : std::nullopt);
        }
}

}
