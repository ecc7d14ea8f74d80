#include "render/software.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <umbral/pipeline/rasterize.hpp>
#include <utility>
#include <vector>

#include "render/clip.hpp"
#include "render/raster.hpp"
#include "render/shading.hpp"
#include "render/tiles.hpp"
#include "render/vertex_stage.hpp"
#include "render/visibility.hpp"

namespace umbral::render {
namespace {

using Corners = std::array<ClipVertex, 3>;

/// A triangle that needs no clipping any more.
struct Item {
    std::array<pipeline::WindowVertex, 3> window;
    Corners corners;
    const Draw* draw;
};

struct Target;
using FragmentKernel = void (*)(const DrawList&, const Item&, const Window&, Target&);
using TriangleKernel = void (*)(const DrawList&, const Draw&, Target&);

/// What all triangles of a picture share.
struct Target {
    Frame& frame;
    Counters& counters;
    glm::vec2 guard;
    FragmentKernel draw_fragments;
    Tiles tiles;
    std::vector<Item> items;                ///< in the tiles
    std::vector<pipeline::ClipVertex> cut;  ///< kept from triangle to triangle, so that memory is asked for once
    std::vector<ClipVertex> polygon;
};

/// So many triangles are kept before they are drawn: 12 MiB of them.
constexpr std::size_t most_items = 1U << 16U;

template <class Attribute>
Attribute interpolate(const glm::vec3& weights, const Corners& corners, Attribute ClipVertex::*attribute)
{
    return weights[0] * corners[0].*attribute + weights[1] * corners[1].*attribute + weights[2] * corners[2].*attribute;
}

template <EffectSet effects>
SurfacePoint surface_point(const Draw& draw, const Corners& corners, const glm::vec3& weights)
{
    SurfacePoint at;
    if constexpr (effects.positional || effects.specular) at.eye = interpolate(weights, corners, &ClipVertex::eye);
    if constexpr (effects.textured) at.uv = interpolate(weights, corners, &ClipVertex::uv);
    at.normal = effects.smooth && draw.smooth ? interpolate(weights, corners, &ClipVertex::normal) : corners[0].normal;
    return at;
}

template <EffectSet effects>
void draw_fragments(const DrawList& list, const Item& item, const Window& window, Target& target)
{
    Frame& frame = target.frame;
    Counters& counters = target.counters;
    const auto covered = [&](int pixels) { counters.fragments += static_cast<std::uint64_t>(pixels); };
    draw_triangle(item.window, window, frame.width(), frame.depth.cells.data(), covered, [&](const Passed& passed) {
        for (std::size_t i = 0; i < lane_count; ++i) {
            if (passed.mask[i] == 0) continue;
            ++counters.fragments_shaded;
            const glm::vec3 weights(passed.weights[0][i], passed.weights[1][i], passed.weights[2][i]);
            const SurfacePoint at = surface_point<effects>(*item.draw, item.corners, weights);
            frame.ids.cells[passed.at + i] = item.draw->id;
            frame.color.cells[passed.at + i] = glm::vec4(shade<effects>(list, *item.draw, at, counters), 1);
        }
    });
}

void draw_items(const DrawList& list, Target& target)
{
    target.tiles.draw_all([&](int left, int top, int right, int bottom, std::uint32_t item) {
        target.draw_fragments(list, target.items[item], {{left, right}, {top, bottom}}, target);
    });
    target.items.clear();
}

template <EffectSet effects>
void add_item(const DrawList& list, const Draw& draw, const Corners& corners, Target& target)
{
    const int width = target.frame.width();
    const int height = target.frame.height();
    Item item{{to_window(corners[0].clip, width, height), to_window(corners[1].clip, width, height),
               to_window(corners[2].clip, width, height)},
              corners,
              &draw};
    if (!is_front(item.window, draw.mirrored)) {
        if (!(effects.two_sided && draw.both_sides)) {
            ++target.counters.triangles_from_behind;
            return;
        }
        ++target.counters.triangles_turned;
        for (ClipVertex& corner : item.corners) corner.normal = -corner.normal;
    }
    ++target.counters.triangles_rasterized;
    const auto& [a, b, c] = item.window;
    target.tiles.add(static_cast<std::uint32_t>(target.items.size()),
                     glm::min(a.position, glm::min(b.position, c.position)),
                     glm::max(a.position, glm::max(b.position, c.position)));
    target.items.push_back(item);
    if (target.items.size() == most_items) draw_items(list, target);
}

template <EffectSet effects>
void draw_triangle(const DrawList& list, const Draw& draw, const Corners& corners, Target& target)
{
    ++target.counters.triangles;
    if (effects.clipped && draw.visibility == Visibility::crosses) {
        target.counters.clip_tests += 3;
        const unsigned a = outcode(corners[0].clip, target.guard);
        const unsigned b = outcode(corners[1].clip, target.guard);
        const unsigned c = outcode(corners[2].clip, target.guard);
        if ((a & b & c) != 0) return;
        if ((a | b | c) != 0) {
            ++target.counters.triangles_clipped;
            target.polygon.clear();
            clip_triangle(corners, target.guard, target.cut, target.polygon);
            for (std::size_t i = 2; i < target.polygon.size(); ++i)
                add_item<effects>(list, draw, {target.polygon[0], target.polygon[i - 1], target.polygon[i]}, target);
            return;
        }
    }
    add_item<effects>(list, draw, corners, target);
}

template <EffectSet effects>
void draw_instance(const DrawList& list, const Draw& draw, Target& target)
{
    const VertexMesh& mesh = list.meshes[draw.mesh];
    std::vector<ClipVertex> placed;
    placed.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) placed.push_back(place_vertex(list, draw, vertex));
    target.counters.vertices += placed.size();
    for (const glm::uvec3& triangle : mesh.triangles)
        draw_triangle<effects>(list, draw, {placed[triangle.x], placed[triangle.y], placed[triangle.z]}, target);
}

// Effects of fragments and of triangles do not mix: 16 kernels for the ones and 4 for the others serve all 64 sets.
constexpr std::size_t fragment_sets = std::size_t{1} << fragment_effects;

template <std::size_t... numbers>
constexpr std::array<FragmentKernel, sizeof...(numbers)> make_fragment_kernels(std::index_sequence<numbers...>)
{
    return {draw_fragments<effect_set(numbers)>...};
}

template <std::size_t... numbers>
constexpr std::array<TriangleKernel, sizeof...(numbers)> make_triangle_kernels(std::index_sequence<numbers...>)
{
    return {draw_instance<effect_set(numbers * fragment_sets)>...};
}

constexpr auto fragment_kernels = make_fragment_kernels(std::make_index_sequence<fragment_sets>());
constexpr auto triangle_kernels = make_triangle_kernels(std::make_index_sequence<effect_set_count / fragment_sets>());

}

SoftwarePicture draw_in_software(const DrawList& list, const EffectSet& effects, int width, int height)
{
    constexpr int most = 16384;
    if (width < 1 || height < 1 || width > most || height > most)
        throw std::invalid_argument("draw_in_software: expected sides of 1 to 16384 pixels, got " +
                                    std::to_string(width) + " x " + std::to_string(height));
    SoftwarePicture picture{Frame(width, height), {}};
    std::vector<float>& depths = picture.frame.depth.cells;
    const std::size_t cells = depths.size();
    depths.resize(cells + lane_count);
    const std::size_t number = number_of(effects);
    Target target{picture.frame,
                  picture.counters,
                  guard_band(width, height),
                  fragment_kernels[number % fragment_sets],
                  Tiles(width, height),
                  {},
                  {},
                  {}};
    const TriangleKernel draw_triangles = triangle_kernels[number / fragment_sets];
    for (const Draw& draw : list.draws) {
        ++(draw.visibility == Visibility::outside ? picture.counters.instances_outside : picture.counters.instances);
        if (draw.visibility != Visibility::outside) draw_triangles(list, draw, target);
    }
    draw_items(list, target);
    depths.resize(cells);
    picture.counters.depth_rejects = picture.counters.fragments - picture.counters.fragments_shaded;
    return picture;
}

}
