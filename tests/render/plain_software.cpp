// The software renderer once more, as plainly as it can be written over the units' interfaces: no tiles, no lanes, no
// kernels. With the rasteriser's oracle it says what the engine's picture should be. It takes the engine's place in
// render-oracle.

#include <umbral/pipeline/rasterize.hpp>

#include "render/clip.hpp"
#include "render/shading.hpp"
#include "render/software.hpp"
#include "render/vertex_stage.hpp"
#include "render/visibility.hpp"

namespace umbral::render {
namespace {

using Corners = std::array<ClipVertex, 3>;

void draw_corners(const DrawList& list, const Draw& draw, Corners corners, Frame& frame)
{
    const auto window = [&](std::size_t i) { return to_window(corners[i].clip, frame.width(), frame.height()); };
    const std::array<pipeline::WindowVertex, 3> triangle = {window(0), window(1), window(2)};
    if (!is_front(triangle, draw.mirrored)) {
        if (!draw.both_sides) return;
        for (ClipVertex& corner : corners) corner.normal = -corner.normal;
    }
    std::vector<pipeline::Fragment> fragments;
    pipeline::rasterize_triangle(triangle, frame.width(), frame.height(), fragments);
    Counters counters;
    for (const auto& [pixel, depth, w] : fragments) {
        if (!(depth < frame.depth.at(pixel.x, pixel.y))) continue;
        const auto& [a, b, c] = corners;
        const SurfacePoint at{w[0] * a.eye + w[1] * b.eye + w[2] * c.eye,
                              draw.smooth ? w[0] * a.normal + w[1] * b.normal + w[2] * c.normal : a.normal,
                              w[0] * a.uv + w[1] * b.uv + w[2] * c.uv};
        frame.depth.at(pixel.x, pixel.y) = depth;
        frame.ids.at(pixel.x, pixel.y) = draw.id;
        frame.color.at(pixel.x, pixel.y) = glm::vec4(shade<all_effects>(list, draw, at, counters), 1);
    }
}

}

SoftwarePicture draw_in_software(const DrawList& list, const EffectSet&, int width, int height)
{
    SoftwarePicture picture{Frame(width, height), {}};
    const glm::vec2 guard = guard_band(width, height);
    std::vector<pipeline::ClipVertex> cut;
    for (const Draw& draw : list.draws) {
        const VertexMesh& mesh = list.meshes[draw.mesh];
        for (const glm::uvec3& triangle : mesh.triangles) {
            const auto corner = [&](int i) { return place_vertex(list, draw, mesh.vertices[triangle[i]]); };
            std::vector<ClipVertex> polygon;
            clip_triangle({corner(0), corner(1), corner(2)}, guard, cut, polygon);
            for (std::size_t i = 2; i < polygon.size(); ++i)
                draw_corners(list, draw, {polygon[0], polygon[i - 1], polygon[i]}, picture.frame);
        }
    }
    return picture;
}

}
