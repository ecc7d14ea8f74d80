#include "render/vertex_light.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "render/clip.hpp"
#include "render/opengl_fixed.hpp"
#include "render/raster.hpp"
#include "render/shading.hpp"
#include "render/vertex_stage.hpp"
#include "render/visibility.hpp"

namespace umbral::render {
namespace {

/// What the fixed function knows of a vertex once its light is computed.
struct LitVertex {
    glm::vec4 clip{0};
    glm::vec2 uv{0};
    glm::vec3 primary{0};    ///< what a texture multiplies
    glm::vec3 highlight{0};  ///< what is added after it
};
using Triangle = std::array<LitVertex, 3>;

template <class Value>
Value blend(const glm::vec3& weights, const Triangle& triangle, Value LitVertex::*value)
{
    return weights[0] * triangle[0].*value + weights[1] * triangle[1].*value + weights[2] * triangle[2].*value;
}

/// An instance without its highlights, and nothing but them.
struct Parts {
    Draw primary;
    Draw highlight;
};

Parts parts_of(const Draw& draw)
{
    Parts parts{draw, draw};
    for (Draw* part : {&parts.primary, &parts.highlight}) part->texture.reset();
    parts.primary.specular = false;
    scene::Material& material = parts.highlight.material;
    material.emission = material.ambient = material.diffuse = glm::vec3(0);
    material.exponent = std::min(material.exponent, fixed_function_exponent);
    return parts;
}

LitVertex light_vertex(const DrawList& list, const Parts& parts, const Vertex& vertex, bool turned)
{
    const ClipVertex placed = place_vertex(list, parts.primary, vertex);
    const SurfacePoint at{placed.eye, turned ? -placed.normal : placed.normal, placed.uv};
    Counters counters;
    return {placed.clip, placed.uv, shade<all_effects>(list, parts.primary, at, counters),
            parts.highlight.specular ? shade<all_effects>(list, parts.highlight, at, counters) : glm::vec3(0)};
}

void draw_part(const DrawList& list, const Draw& draw, const Triangle& triangle,
               const std::array<pipeline::WindowVertex, 3>& window, Frame& frame)
{
    const Window all{{0, frame.width() - 1}, {0, frame.height() - 1}};
    draw_triangle(
        window, all, frame.width(), frame.depth.cells.data(), [](int) {},
        [&](const Passed& passed) {
            for (std::size_t i = 0; i < lane_count; ++i) {
                if (passed.mask[i] == 0) continue;
                const glm::vec3 weights(passed.weights[0][i], passed.weights[1][i], passed.weights[2][i]);
                glm::vec3 color = blend(weights, triangle, &LitVertex::primary);
                if (draw.texture) {
                    const Texture& texture = list.textures[*draw.texture];
                    const glm::vec2 uv = blend(weights, triangle, &LitVertex::uv) * draw.material.texture_scale;
                    color *= glm::vec3(texturing::lookup(texture.texels, texture.sampler, uv));
                }
                color += blend(weights, triangle, &LitVertex::highlight);
                frame.ids.cells[passed.at + i] = draw.id;
                frame.color.cells[passed.at + i] = glm::vec4(color, 1);
            }
        });
}

/// The corners of one side's picture of a mesh, and of the other side's where both are shown.
struct LitMesh {
    std::vector<LitVertex> front;
    std::vector<LitVertex> back;
};

LitMesh light_mesh(const DrawList& list, const Draw& draw)
{
    const Parts parts = parts_of(draw);
    LitMesh lit;
    for (const Vertex& vertex : list.meshes[draw.mesh].vertices) {
        lit.front.push_back(light_vertex(list, parts, vertex, false));
        if (draw.both_sides) lit.back.push_back(light_vertex(list, parts, vertex, true));
    }
    return lit;
}

void draw_instance(const DrawList& list, const Draw& draw, const glm::vec2& guard, Frame& frame)
{
    const LitMesh lit = light_mesh(list, draw);
    std::vector<pipeline::ClipVertex> polygon;
    for (const glm::uvec3& indices : list.meshes[draw.mesh].triangles) {
        const auto corners = [&](const std::vector<LitVertex>& side) {
            return Triangle{side[indices.x], side[indices.y], side[indices.z]};
        };
        const Triangle front = corners(lit.front);
        clip_positions({front[0].clip, front[1].clip, front[2].clip}, guard, polygon);
        for (std::size_t i = 2; i < polygon.size(); ++i) {
            const std::array<const pipeline::ClipVertex*, 3> fan = {&polygon[0], &polygon[i - 1], &polygon[i]};
            std::array<pipeline::WindowVertex, 3> window{};
            for (std::size_t k = 0; k < 3; ++k) window[k] = to_window(fan[k]->position, frame.width(), frame.height());
            const bool is_turned = !is_front(window, draw.mirrored);
            if (is_turned && !draw.both_sides) continue;
            const Triangle whole = is_turned ? corners(lit.back) : front;
            Triangle part;
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::vec3& weights = fan[k]->weights;
                part[k] = {fan[k]->position, blend(weights, whole, &LitVertex::uv),
                           blend(weights, whole, &LitVertex::primary), blend(weights, whole, &LitVertex::highlight)};
            }
            draw_part(list, draw, part, window, frame);
        }
    }
}

}

Frame draw_with_light_at_vertices(const DrawList& list, int width, int height)
{
    Frame frame(width, height);
    const std::size_t cells = frame.depth.cells.size();
    frame.depth.cells.resize(cells + lane_count);
    const glm::vec2 guard = guard_band(width, height);
    for (const Draw& draw : list.draws)
        if (draw.visibility != Visibility::outside) draw_instance(list, draw, guard, frame);
    frame.depth.cells.resize(cells);
    return frame;
}

}
