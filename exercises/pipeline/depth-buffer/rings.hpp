#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <kit/drawing.hpp>
#include <kit/shapes.hpp>
#include <umbral/core/grid.hpp>
#include <umbral/pipeline/depth.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

/// The goal picture of pipeline/depth-buffer: two rings, each drawn into a layer of its own, that are linked once the
/// layers are merged.
namespace umbral::pipeline {

/// The grid, if it still has the size that it was handed out with; else an empty one of that size.
template <class Cell>
Grid<Cell> of_size(const Grid<Cell>& grid, int width, int height)
{
    Grid<Cell> blank(width, height);
    return grid.width == width && grid.height == height && grid.cells.size() == blank.cells.size() ? grid : blank;
}

struct Ring {
    glm::vec3 centre, along, across;  ///< the ring runs from `along` to `across`, unit vectors
    glm::vec3 color;
};

namespace detail {

inline constexpr int panel = 210;

/// Where the unit sees a point in a parallel projection: x and y in panels, z towards the viewer from -1 to 1.
inline WindowVertex in_window(const glm::vec3& place)
{
    return {0.5F * panel * glm::vec2(1 + place.x, 1 - place.y), 0.5F - 0.5F * place.z, 1};
}

inline glm::vec3 shaded(const glm::vec3& normal, const glm::vec3& color)
{
    const glm::vec3 light = glm::normalize(glm::vec3(-0.5F, 0.7F, 0.75F));
    const float shine = std::pow(std::max(0.0F, glm::dot(normal, glm::normalize(light + glm::vec3(0, 0, 1)))), 40.0F);
    return (0.12F + 0.88F * std::max(0.0F, glm::dot(normal, light))) * color + 0.5F * shine;
}

inline void draw_ring(Recorder& out, const Ring& ring, const DepthState& state, ShadeModel model, Layer& layer)
{
    const glm::mat3 axes(ring.along, ring.across, glm::cross(ring.along, ring.across));
    const shapes::Shape torus = shapes::torus(34, 14, 0.34F);
    std::vector<Fragment> fragments;
    for (std::size_t i = 0; i < torus.indices.size(); i += 3) {
        std::array<WindowVertex, 3> corners{};
        std::array<glm::vec3, 3> colors{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = torus.indices[i + k];
            corners[k] = in_window(ring.centre + 0.5F * (axes * torus.positions[vertex]));
            colors[k] = shaded(axes * torus.normals[vertex], ring.color);
        }
        fragments.clear();
        rasterize_triangle(corners, panel, panel, fragments);
        ask<draw_fragments>(out, state, model, colors, fragments, layer);
    }
}

/// What is drawn into the layer that is merged into, and into the other one.
struct Rings {
    Ring left{{-0.24F, 0.08F, 0}, {1, 0, 0}, glm::normalize(glm::vec3(0.1F, 0.9F, -0.45F)), {0.09F, 0.42F, 0.8F}};
    Ring right{{0.24F, -0.08F, 0}, {1, 0, 0}, glm::normalize(glm::vec3(0, 0.55F, 0.84F)), {0.85F, 0.32F, 0.02F}};
};

/// Rings tilted otherwise, in other colours; they remain linked.
inline Rings varied(Variation& vary, Rings rings)
{
    for (Ring* const ring : {&rings.left, &rings.right}) {
        const glm::mat3 turn = vary.turn({1, 0, 0}, 0.25F);
        ring->across = vary ? turn * ring->across : ring->across;
        ring->color = glm::clamp(vary.near(ring->color, 0.3F), 0.0F, 1.0F);
        ring->centre.y = vary.near(ring->centre.y, 0.08F);
    }
    return rings;
}

inline Layer linked_rings(Recorder& out, const Rings& rings, const DepthState& state, ShadeModel model)
{
    const Layer empty{{panel, panel, glm::vec3(srgb_decoded(glm::dvec3(ink::night)))}, {panel, panel, 1.0F}};
    Layer left = empty;
    Layer right = empty;
    draw_ring(out, rings.left, state, model, left);
    draw_ring(out, rings.right, state, model, right);
    ask<merge_layers>(out, state, right, left);
    return {of_size(left.colors, panel, panel), of_size(left.depths, panel, panel)};
}

}

/// Flat, smooth, and the depths themselves, side by side.
inline Image draw_rings(Recorder& out, Variation& vary)
{
    const detail::Rings rings = varied(vary, detail::Rings{});
    const DepthState state{true, DepthFunction::less, true, DepthFormat::unorm16};
    const Layer flat = detail::linked_rings(out, rings, state, ShadeModel::flat);
    const Layer smooth = detail::linked_rings(out, rings, state, ShadeModel::smooth);
    Image picture(3 * detail::panel, detail::panel);
    for (int y = 0; y < detail::panel; ++y)
        for (int x = 0; x < detail::panel; ++x) {
            const float depth = smooth.depths.at(x, y);
            const float near = 1.25F - 1.5F * std::clamp(depth, 0.0F, 1.0F);
            picture.at(x, y) = pixel_of(flat.colors.at(x, y));
            picture.at(detail::panel + x, y) = pixel_of(smooth.colors.at(x, y));
            picture.at(2 * detail::panel + x, y) =
                pixel_of(depth < 1 ? near * near * ink::white : smooth.colors.at(x, y));
        }
    return picture;
}

}
