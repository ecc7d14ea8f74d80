#include "render/software.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <umbral/pipeline/rasterize.hpp>
#include <utility>
#include <vector>

#include "render/clip.hpp"
#include "render/shading.hpp"
#include "render/vertex_stage.hpp"
#include "render/visibility.hpp"

namespace umbral::render {
namespace {

using Corners = std::array<ClipVertex, 3>;

struct Target;
using FragmentKernel = void (*)(const DrawList&, const Draw&, const Corners&, const Target&);
using TriangleKernel = void (*)(const DrawList&, const Draw&, const Target&);

/// What all triangles of a picture share.
struct Target {
    Frame& frame;
    Counters& counters;
    std::vector<pipeline::Fragment>& fragments;  ///< of one triangle; kept, so that memory is asked for once
    glm::vec2 guard;
    FragmentKernel draw_fragments;
};

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
void draw_fragments(const DrawList& list, const Draw& draw, const Corners& corners, const Target& target)
{
    Frame& frame = target.frame;
    target.counters.fragments += target.fragments.size();
    for (const pipeline::Fragment& fragment : target.fragments) {
        // rasterize_triangle gives pixels of the picture only.
        const std::size_t pixel =
            static_cast<std::size_t>(fragment.pixel.y) * static_cast<std::size_t>(frame.width()) + static_cast<std::size_t>(fragment.pixel.x);
        if (!(fragment.depth < frame.depth.cells[pixel])) {
            ++target.counters.depth_rejects;
            continue;
        }
        ++target.counters.fragments_shaded;
        frame.depth.cells[pixel] = fragment.depth;
        frame.ids.cells[pixel] = draw.id;
        frame.color.cells[pixel] = glm::vec4(shade<effects>(list, draw, surface_point<effects>(draw, corners, fragment.weights), target.counters), 1);
    }
}

/// A triangle that needs no clipping any more.
template <EffectSet effects>
void rasterize(const DrawList& list, const Draw& draw, Corners corners, const Target& target)
{
    const int width = target.frame.width();
    const int height = target.frame.height();
    const std::array<pipeline::WindowVertex, 3> window = {to_window(corners[0].clip, width, height), to_window(corners[1].clip, width, height),
                                                          to_window(corners[2].clip, width, height)};
    if (!is_front(window, draw.mirrored)) {
        if (!(effects.two_sided && draw.both_sides)) {
            ++target.counters.triangles_from_behind;
            return;
        }
        ++target.counters.triangles_turned;
        for (ClipVertex& corner : corners) corner.normal = -corner.normal;
    }
    ++target.counters.triangles_rasterized;
    target.fragments.clear();
    pipeline::rasterize_triangle(window, width, height, target.fragments);
    target.draw_fragments(list, draw, corners, target);
}

template <EffectSet effects>
void draw_triangle(const DrawList& list, const Draw& draw, const Corners& corners, const Target& target)
{
    ++target.counters.triangles;
    if (effects.clipped && draw.visibility == Visibility::crosses) {
        target.counters.clip_tests += 3;
        const std::array<unsigned, 3> codes = {outcode(corners[0].clip, target.guard), outcode(corners[1].clip, target.guard),
                                               outcode(corners[2].clip, target.guard)};
        if ((codes[0] & codes[1] & codes[2]) != 0) return;
        if (const unsigned planes = codes[0] | codes[1] | codes[2]; planes != 0) {
            ++target.counters.triangles_clipped;
            const ClipPolygon polygon = clip_triangle(corners, planes, target.guard);
            for (std::size_t i = 2; i < polygon.size; ++i)
                rasterize<effects>(list, draw, {polygon.corners[0], polygon.corners[i - 1], polygon.corners[i]}, target);
            return;
        }
    }
    rasterize<effects>(list, draw, corners, target);
}

template <EffectSet effects>
void draw_instance(const DrawList& list, const Draw& draw, const Target& target)
{
    const VertexMesh& mesh = list.meshes[draw.mesh];
    std::vector<ClipVertex> placed;
    placed.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) placed.push_back(place_vertex(list, draw, vertex));
    target.counters.vertices += placed.size();
    for (const glm::uvec3& triangle : mesh.triangles) draw_triangle<effects>(list, draw, {placed[triangle.x], placed[triangle.y], placed[triangle.z]}, target);
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
        throw std::invalid_argument("draw_in_software: expected sides of 1 to 16384 pixels, got " + std::to_string(width) + " x " + std::to_string(height));
    SoftwarePicture picture{Frame(width, height), {}};
    std::vector<pipeline::Fragment> fragments;
    const std::size_t number = number_of(effects);
    const Target target{picture.frame, picture.counters, fragments, guard_band(width, height), fragment_kernels[number % fragment_sets]};
    const TriangleKernel draw_triangles = triangle_kernels[number / fragment_sets];
    for (const Draw& draw : list.draws) {
        ++(draw.visibility == Visibility::outside ? picture.counters.instances_outside : picture.counters.instances);
        if (draw.visibility != Visibility::outside) draw_triangles(list, draw, target);
    }
    return picture;
}

}
