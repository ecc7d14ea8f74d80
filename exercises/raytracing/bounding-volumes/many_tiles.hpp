#pragma once

#include <memory>
#include <string>
#include <umbral/raytracing/bounding_volumes.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "soups.hpp"

namespace umbral::raytracing {

/// More triangles than 16 bits count: tiles that lie apart, each seen by a ray of its own from above.
inline void many(Recorder& out, Random& random)
{
    constexpr std::uint32_t in_a_row = 257;
    Soup tiles;
    for (std::uint32_t i = 0; i < in_a_row * in_a_row; ++i) {
        const glm::vec3 corner(i % in_a_row, i / in_a_row, 0);
        tiles.push_back({corner, corner + glm::vec3(0.75F, 0, 0), corner + glm::vec3(0, 0.75F, 0)});
    }
    const std::unique_ptr<TriangleHierarchy> hierarchy = make_triangle_hierarchy(tiles);
    for (int i = 0; i < 30; ++i) {
        const std::uint32_t tile = i % 2 == 0 ? 0xFFFF + random.below(in_a_row + 2) : random.below(0xFFFF);
        const Ray ray{tiles[tile].v0 + glm::vec3(0.25F, 0.25F, 3), {0, 0, -1}};
        ask_in_words(out, [&] {
            const std::string row = std::to_string(in_a_row);
            return "// " + std::to_string(tiles.size()) + " triangles; number i has its right angle at (i % " + row +
                   ", i / " + row + ", 0), and legs 0.75 long along +x and +y\nhierarchy->first_hit(" +
                   literal::of_value(ray, true, {}) + ");";
        });
        std::optional<FirstTriangle> first;
        if (hierarchy) first = hierarchy->first_hit(ray);
        out.append("index", first ? std::optional(static_cast<float>(first->index)) : std::nullopt);
    }
}

}
