// Based on: M. Segal, K. Akeley. The OpenGL Graphics System, version 4.5, chapters 13 and 14.

#include <algorithm>
#include <cmath>
#include <umbral/pipeline/software.hpp>

namespace umbral::pipeline {
namespace {

// A corner of what is left of a triangle, in the viewport.
struct Corner {
    WindowVertex window;
    glm::vec3 weights;  // of the triangle's vertices
};
using Polygon = std::vector<Corner>;

Corner to_window(const ClipVertex& vertex, const Viewport& viewport)
{
    const float inverse_w = 1 / vertex.position.w;
    const glm::vec3 ndc = glm::vec3(vertex.position) * inverse_w;
    const glm::vec2 half = 0.5F * glm::vec2(viewport.width, viewport.height);
    const float depth = viewport.near_depth + (viewport.far_depth - viewport.near_depth) * (0.5F * ndc.z + 0.5F);
    return {{{half.x + half.x * ndc.x, half.y - half.y * ndc.y}, depth, inverse_w}, vertex.weights};
}

// y goes down here: counter-clockwise as one sees it is a negative area.
bool shows_front(const Polygon& polygon)
{
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a(polygon[i].window.position);
        const glm::dvec2 b(polygon[(i + 1) % polygon.size()].window.position);
        area += a.x * b.y - a.y * b.x;
    }
    return area < 0;
}

bool is_culled(Culling culling, bool front) { return culling == (front ? Culling::front : Culling::back); }

void fill(const Polygon& polygon, const Viewport& viewport, std::vector<Fragment>& fragments)
{
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const auto& [a, b, c] = std::array{polygon[0], polygon[i - 1], polygon[i]};
        const std::size_t begin = fragments.size();
        rasterize_triangle({a.window, b.window, c.window}, viewport.width, viewport.height, fragments);
        // From weights of the polygon's corners to those of the triangle's.
        const glm::mat3 to_triangle(a.weights, b.weights, c.weights);
        for (std::size_t k = begin; k < fragments.size(); ++k)
            fragments[k].weights = to_triangle * fragments[k].weights;
    }
}

glm::dvec2 rounded(const glm::vec2& position)
{
    return {std::nearbyint(position.x * 256.0) / 256, std::nearbyint(position.y * 256.0) / 256};
}

// Products of multiples of 1/256 are exact, and so is the quotient where it is whole: both directions give the same
// pixels.
void line(const Corner& a, const Corner& b, std::vector<Fragment>& fragments)
{
    const glm::dvec2 from = rounded(a.window.position);
    const glm::dvec2 along = rounded(b.window.position) - from;
    const int major = std::abs(along.x) >= std::abs(along.y) ? 0 : 1;
    const int minor = 1 - major;
    const double low = std::min(from[major], from[major] + along[major]);
    const double high = std::max(from[major], from[major] + along[major]);
    for (int i = static_cast<int>(std::ceil(low - 0.5)); i + 0.5 < high; ++i) {
        const double centre = i + 0.5;
        const double t = (centre - from[major]) / along[major];
        glm::dvec2 place(centre);
        place[minor] = from[minor] + (centre - from[major]) * along[minor] / along[major];
        const auto share =
            static_cast<float>(t * b.window.inverse_w / ((1 - t) * a.window.inverse_w + t * b.window.inverse_w));
        fragments.push_back({glm::ivec2(floor(place)),
                             static_cast<float>(glm::mix(double{a.window.depth}, double{b.window.depth}, t)),
                             glm::mix(a.weights, b.weights, share)});
    }
}

// A side of the triangle, or a part of one: the vertex opposite has no weight all along it. Others were made by
// clipping.
bool is_part_of_a_side(const Corner& a, const Corner& b)
{
    return glm::any(glm::equal(glm::max(a.weights, b.weights), glm::vec3(0)));
}

// Calls visit(begin, end) for each of those sides.
template <class Visit>
void for_each_side(const Polygon& polygon, const Visit& visit)
{
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner& next = polygon[(i + 1) % polygon.size()];
        if (is_part_of_a_side(polygon[i], next)) visit(polygon[i], next);
    }
}

void outline(const Polygon& polygon, std::vector<Fragment>& fragments)
{
    for_each_side(polygon, [&](const Corner& a, const Corner& b) { line(a, b, fragments); });
}

void corners(const Polygon& polygon, std::vector<Fragment>& fragments)
{
    for_each_side(polygon, [&](const Corner& a, const Corner&) {
        fragments.push_back({glm::ivec2(floor(rounded(a.window.position))), a.window.depth, a.weights});
    });
}

// From the viewport to the picture; what lies outside one of them goes.
void place(const Viewport& viewport, const Layer& target, std::vector<Fragment>& fragments)
{
    const glm::ivec2 offset(viewport.left, viewport.top);
    std::erase_if(fragments, [&](const Fragment& fragment) {
        const glm::ivec2 pixel = fragment.pixel;
        const bool in_viewport = pixel.x >= 0 && pixel.y >= 0 && pixel.x < viewport.width && pixel.y < viewport.height;
        return !in_viewport || !target.depths.contains(pixel.x + offset.x, pixel.y + offset.y);
    });
    for (Fragment& fragment : fragments) fragment.pixel += offset;
}

}

void draw_triangles(const PipelineState& state, std::span<const ColoredVertex> vertices,
                    std::span<const glm::uvec3> triangles, Layer& target)
{
    std::vector<glm::vec4> clip;
    for (const ColoredVertex& vertex : vertices) clip.push_back(state.to_clip * glm::vec4(vertex.position, 1));

    // Kept from triangle to triangle, so that memory is asked for once.
    std::vector<ClipVertex> clipped;
    Polygon polygon;
    std::vector<Fragment> fragments;
    for (const glm::uvec3& triangle : triangles) {
        clipped.clear();
        clip_triangle({clip[triangle.x], clip[triangle.y], clip[triangle.z]}, clipped);
        if (clipped.empty()) continue;
        polygon.clear();
        for (const ClipVertex& corner : clipped) polygon.push_back(to_window(corner, state.viewport));
        if (is_culled(state.culling, shows_front(polygon))) continue;

        fragments.clear();
        switch (state.mode) {
            case PolygonMode::fill: fill(polygon, state.viewport, fragments); break;
            case PolygonMode::line: outline(polygon, fragments); break;
            case PolygonMode::point: corners(polygon, fragments); break;
        }
        place(state.viewport, target, fragments);
        draw_fragments(state.depth, state.shading,
                       {vertices[triangle.x].color, vertices[triangle.y].color, vertices[triangle.z].color}, fragments,
                       target);
    }
}

}
