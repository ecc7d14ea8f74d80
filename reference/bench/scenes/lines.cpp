// Lines: OpenGL's own, and as thin strips of triangles.

#include <algorithm>
#include <cmath>

#include "scenes.hpp"
#include "shapes.hpp"
#include "staging.hpp"

namespace umbral::bench::scenes {
namespace {

Batch drawn_lines(Triangles corners, const glm::mat4& placed, const glm::vec4& color)
{
    Batch batch;
    batch.corners = std::move(corners);
    batch.lines = true;
    batch.edge_corners = 2;
    batch.model = placed;
    batch.material = plain_paint(color);
    return batch;
}

Model wireframe(const Pose& pose)
{
    Model m = framed(pose, {0, 2.0F, 3.2F});
    m.background = {0.05F, 0.07F, 0.10F, 1};
    m.encoded = false;
    m.batches = {drawn_lines(edges_of(torus(0.4F, 24, 12)), pose.put({0, 0, 0}, 20 * pose.time(), {0.2F, 1, 0.3F}),
                             {0.4F, 0.95F, 0.6F, 1})};
    return m;
}

// The lines behind the surface are hidden.
Model hidden_lines(const Pose& pose)
{
    Model m = framed(pose, {0.4F, 1.6F, 3.0F});
    m.background = {1, 1, 1, 1};
    m.encoded = false;
    const Triangles mesh = gem(2);
    const glm::mat4 placed = pose.put({0, 0, 0}, 20 * pose.time(), {0.3F, 1, 0}, {1.1F, 0.85F, 0.9F});
    m.batches = {solid(mesh, placed, plain_paint({0.86F, 0.90F, 0.95F, 1})),
                 drawn_lines(edges_of(mesh), placed, {0.1F, 0.15F, 0.35F, 1})};
    m.batches[1].depth_offset = 2e-3F;
    return m;
}

Model star(const Pose& pose)
{
    Model m = flat_picture(pose.size, pose.size, 2);
    m.background = {1, 1, 1, 1};
    Triangles rays;
    for (int i = 0; i < 48; ++i) {
        const float a = 6.2831853F * (static_cast<float>(i) + 0.5F * pose.time()) / 48 + 0.01F;
        const glm::vec2 along(std::cos(a), std::sin(a));
        const float length = i % 3 == 0 ? 0.95F : 0.75F;
        rays.push_back({{0.12F * along + glm::vec2(0.05F, 0.03F), 0}, {0, 0, 1}, {0, 0}, {0, 0, 0, 1}});
        rays.push_back(
            {{(pose.flaw == Flaw::line_end_missing ? 0.8F : 1.0F) * length * along + glm::vec2(0.05F, 0.03F), 0},
             {0, 0, 1},
             {0, 0},
             {0.1F, 0.1F, 0.5F, 1}});
    }
    m.batches = {drawn_lines(rays, glm::mat4(1), glm::vec4(1))};
    return m;
}

// Twice as wide as high: curves and axes.
Model plot(const Pose& pose)
{
    Model m = flat_picture(2 * pose.size, pose.size, 2);
    m.background = {0.99F, 0.99F, 0.98F, 1};
    Batch ink = solid({}, glm::mat4(1), plain_paint());
    ink.edge_corners = 6;
    const float width = (pose.flaw == Flaw::line_width_wrong ? 2.0F : 1.0F) * 3.2F / static_cast<float>(pose.size);
    const auto stroke = [&](glm::vec2 from, glm::vec2 to, const glm::vec4& color) {
        if (pose.flaw == Flaw::line_end_missing) to = glm::mix(from, to, 0.8F);
        add_stroke(ink.corners, from, to, width, color);
    };
    for (int i = 0; i <= 8; ++i)
        stroke({-1.8F + 0.45F * static_cast<float>(i), -0.85F}, {-1.8F + 0.45F * static_cast<float>(i), 0.85F},
               {0.8F, 0.8F, 0.82F, 1});
    for (int i = 0; i <= 4; ++i)
        stroke({-1.8F, -0.85F + 0.425F * static_cast<float>(i)}, {1.8F, -0.85F + 0.425F * static_cast<float>(i)},
               {0.8F, 0.8F, 0.82F, 1});
    stroke({-1.9F, 0}, {1.9F, 0}, {0.1F, 0.1F, 0.1F, 1});
    stroke({-1.8F, -0.95F}, {-1.8F, 0.95F}, {0.1F, 0.1F, 0.1F, 1});
    const auto curve = [&](const auto& f, const glm::vec4& color) {
        for (int i = 0; i < 60; ++i) {
            const float x = -1.8F + 0.06F * static_cast<float>(i);
            stroke({x, f(x)}, {x + 0.06F, f(x + 0.06F)}, color);
        }
    };
    const float phase = 0.3F * pose.time();
    curve([&](float x) { return 0.7F * std::sin(3 * x + phase); }, {0.8F, 0.2F, 0.15F, 1});
    curve([&](float x) { return 0.6F * std::exp(-x * x) * std::cos(9 * x); }, {0.15F, 0.35F, 0.75F, 1});
    ink.depth_test = false;
    m.batches = {ink};
    return m;
}

/// OpenGL's lines have no counterpart in software.
Scene of_lines(Scene scene)
{
    scene.ways = {Way::other_gl_back_end, Way::triangles_reordered, Way::ends_swapped, Way::indexed_mesh,
                  Way::stepwise_matrices};
    return scene;
}

}

std::vector<Scene> line_scenes(int size)
{
    using namespace groups;
    using enum Flaw;
    return {
        of_lines(
            model_scene("wireframe mesh", "The edges of a ring, one pixel wide.", Home::opengl, size, wireframe,
                        {any,
                         placed,
                         {missing_edge, line_width_wrong, rotation_sign, stale_frame, gamma_twice, brightness_5_percent,
                          green_5_percent, near_plane_too_far, far_plane_too_near, sixteen_levels}})),
        of_lines(model_scene(
            "hidden lines", "The edges of a solid, those behind it hidden.", Home::opengl, size, hidden_lines,
            {any,
             placed,
             {missing_edge, missing_triangle, line_width_wrong, rotation_sign, stale_frame, z_fighting, depth_test_off,
              depth_inverted, front_faces_culled, gamma_twice, brightness_5_percent}})),
        of_lines(model_scene("thin lines", "Rays of one pixel on white.", Home::opengl, size, star,
                             {any,
                              {missing_edge, line_width_wrong, line_end_missing, stale_frame, gamma_twice,
                               fov_3_percent_wrong, camera_1_percent_off}})),
        model_scene("function plot", "Axes, a grid and two curves, as strokes of one or two pixels.", Home::software,
                    size, plot,
                    {any,
                     {missing_edge, line_width_wrong, line_end_missing, stale_frame, aspect_ignored,
                      fov_3_percent_wrong, camera_1_percent_off, gamma_twice, brightness_5_percent, green_5_percent}}),
    };
}

}
