#pragma once

#include <array>
#include <kit/double_frame.hpp>
#include <numbers>

#include "../gl_pipelines.hpp"
#include "graphs.hpp"

namespace umbral::transforms {

/// Two rows of facades under a moon: one facade, 24 times.
inline SceneGraph street()
{
    GraphBuilder b;
    const std::uint32_t home = add_facade(b);
    const std::uint32_t pair = b.add_node({node(home), b.move(2.25F, 0), b.scale(-1.1F, 1.2F), node(home)});
    const std::uint32_t block = b.add_node({node(pair), b.move(2.35F, 0), b.scale(0.85F, 0.8F), node(pair)});
    const std::uint32_t row = b.add_node({node(block), b.move(4.35F, 0), node(block)});
    const std::uint32_t hill =
        b.add_node({b.move(1.0F, 0.95F), b.scale(0.5F, 0.5F), node(row), b.move(8.6F, 0), node(row)});
    const std::uint32_t moon = b.add_node({b.move(7.75F, 3.05F), b.scale(0.42F, 0.42F), object(circle)});
    b.graph.root = b.add_node({node(moon), node(hill), node(row)});
    return b.graph;
}

/// The lines of a simple object, closed and convex, in its own coordinates.
inline std::vector<glm::vec2> outline_of(std::uint32_t object)
{
    switch (object) {
        case square: return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        case triangle: return {{0, 0}, {1, 0}, {0, 1}};
        case house: return {{0, 0}, {1, 0}, {1, 1}, {0.5F, 1.5F}, {0, 1}};
        default: break;
    }
    constexpr int corners = 32;
    std::vector<glm::vec2> round;
    for (int i = 0; i < corners; ++i) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / corners;
        round.emplace_back(std::cos(angle), std::sin(angle));
    }
    return round;
}

/// 560 x 240 pixels, by the programmable pipeline.
inline Image draw_street(const std::vector<Instance>& instances)
{
    constexpr glm::vec3 night(0.055F, 0.06F, 0.13F);
    constexpr std::array walls{glm::vec3(0.20F, 0.33F, 0.50F), glm::vec3(0.42F, 0.25F, 0.40F),
                               glm::vec3(0.18F, 0.42F, 0.42F), glm::vec3(0.48F, 0.32F, 0.24F)};
    constexpr std::array<glm::vec3, 4> fills{glm::vec3(0.96F, 0.80F, 0.42F), glm::vec3(0.80F, 0.32F, 0.26F),
                                             glm::vec3(0.97F, 0.95F, 0.85F), glm::vec3(0)};
    const DoubleFrame frame(560, 240, night);
    ProgrammablePipeline pipeline(make_matrix_stack(), glm::ortho(-0.4F, 8.95F, -0.25F, 3.757F), night, 2);
    pipeline.set_line_width(1);
    std::size_t houses = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(instances.size(), 2000); ++i) {
        const auto& [object, world] = instances[i];
        const std::vector<glm::vec2> outline = outline_of(object);
        std::vector<glm::vec2> fan;
        for (std::size_t k = 2; k < outline.size(); ++k)
            fan.insert(fan.end(), {outline[0], outline[k - 1], outline[k]});
        pipeline.set_view(world);
        pipeline.set_color(object == house ? walls[houses++ % walls.size()] : fills[object % fills.size()]);
        pipeline.fill_triangles(fan);
        if (object == circle) continue;
        std::vector<glm::vec2> closed = outline;
        closed.push_back(outline[0]);
        pipeline.set_color(night);
        pipeline.draw_polyline(closed);
    }
    return frame.picture();
}

}
