#include <gtest/gtest.h>

#include <umbral/pipeline/software.hpp>

#include "render/software.hpp"
#include "render/vertex_stage.hpp"
#include "scenes.hpp"

// The engine's software renderer and the unit pipeline/software-pipeline join the same stages: they must see the same
// things in the same places.
namespace umbral::render::test {
namespace {

/// Instances in flat colours, their ids; by the unit, from positions in eye space on, so that both round alike.
pipeline::Layer drawn_by_the_unit(const DrawList& list, int width, int height)
{
    pipeline::Layer layer{Grid<glm::vec3>(width, height), Grid<float>(width, height, 1)};
    for (const Draw& draw : list.draws) {
        if (draw.visibility == Visibility::outside) continue;
        const VertexMesh& mesh = list.meshes[draw.mesh];
        std::vector<pipeline::ColoredVertex> vertices;
        for (const Vertex& vertex : mesh.vertices)
            vertices.push_back({place_vertex(list, draw, vertex).eye, glm::vec3(static_cast<float>(draw.id))});
        pipeline::PipelineState state;
        state.to_clip = list.projection;
        state.viewport = {0, 0, width, height, 0, 1};
        state.shading = pipeline::ShadeModel::flat;
        if (!draw.both_sides) state.culling = draw.mirrored ? pipeline::Culling::front : pipeline::Culling::back;
        pipeline::draw_triangles(state, vertices, mesh.triangles, layer);
    }
    return layer;
}

struct Difference {
    std::size_t drawn = 0, ids = 0;
    float depth = 0;  ///< the largest where the ids agree
};

Difference difference(const scene::Scene& scene, int width, int height)
{
    const DrawList list = make_draw_list(scene, width, height);
    const Frame frame = draw_in_software(list, derive_effects(list, scene).set, width, height).frame;
    const pipeline::Layer layer = drawn_by_the_unit(list, width, height);
    Difference result;
    for (std::size_t i = 0; i < frame.ids.cells.size(); ++i) {
        const bool same = layer.colors.cells[i].r == static_cast<float>(frame.ids.cells[i]);
        result.drawn += frame.ids.cells[i] != 0 ? 1U : 0U;
        result.ids += same ? 0U : 1U;
        if (same) result.depth = std::max(result.depth, std::abs(layer.depths.cells[i] - frame.depth.cells[i]));
    }
    return result;
}

TEST(UnitPipeline, is_the_engines_where_nothing_is_clipped)
{
    for (const scene::Scene& scene : {plain(), mirrored(), degenerate()}) {
        const Difference d = difference(scene, 200, 150);
        EXPECT_EQ(d.ids, 0U) << scene.title;
        EXPECT_LE(d.depth, 0x1p-24F) << scene.title;
        EXPECT_GT(d.drawn, 500U);
    }
}

// The engine clips at a guard band, the unit at the picture's sides: edges move by a part of 1/256 pixel, and depths
// with them.
TEST(UnitPipeline, is_nearly_the_engines_where_triangles_are_clipped)
{
    for (const scene::Scene& scene : {first_light(), through_the_near_plane(), around_the_camera()}) {
        const Difference d = difference(scene, 200, 150);
        EXPECT_LE(d.ids, 2U);
        EXPECT_GT(d.drawn, 5000U);
    }
}

}
}
