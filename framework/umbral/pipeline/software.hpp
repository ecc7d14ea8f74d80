#pragma once

#include <glm/glm.hpp>
#include <span>
#include <umbral/core/not_implemented.hpp>
#include <umbral/pipeline/assembly.hpp>
#include <umbral/pipeline/clip.hpp>
#include <umbral/pipeline/depth.hpp>
#include <umbral/pipeline/rasterize.hpp>

namespace umbral::pipeline {

/// A vertex as the application has it.
struct ColoredVertex {
    glm::vec3 position;
    glm::vec3 color;  ///< linear
};

/// The part of the picture that the view volume is drawn to. It may reach beyond the picture. Sizes are 1 to 16384.
struct Viewport {
    int left = 0, top = 0;  ///< its first column and row, from the upper left (OpenGL counts rows from below)
    int width = 1, height = 1;
    float near_depth = 0,
          far_depth = 1;  ///< in [0, 1]: what the near plane and the far plane become; near may be the larger one
};

/// All that a draw depends on beside its vertices.
struct PipelineState {
    glm::mat4 to_clip{1};  ///< model, view and projection: m * (position, 1) are clip coordinates
    Viewport viewport;
    Culling culling = Culling::none;
    PolygonMode mode = PolygonMode::fill;
    ShadeModel shading = ShadeModel::smooth;
    DepthState depth;
};

/// Draws triangles, the indices of three vertices each, in their order: from the application's vertices to the picture,
/// as OpenGL does it.
///
/// 1. Vertices go to clip coordinates.
/// 2. Triangles are clipped there (clip_triangle): corners may lie behind the camera.
/// 3. What is left of a triangle, a polygon, is divided by w and brought to the viewport: x = -1 becomes its left
/// border, x = 1 the right one,
///    y = 1 the **upper** and y = -1 the lower one, z = -1 becomes near_depth and z = 1 far_depth.
/// 4. A polygon shows its front if its corners go round counter-clockwise on the screen; `culling` says what is
/// dropped.
/// 5. `mode` says what is left of the polygon:
///    - `fill`: its triangles, from its first corner to each other side, by rasterize_triangle;
///    - `line`: its sides, but not those that clipping made: only sides along which one of the triangle's corners has
///      the weight 0, exactly, at both ends. Ends are rounded to 1/256 pixel first, as the rasteriser does it. A side
///      that is then at least as wide as high gives one fragment for each column whose centre lies between its ends,
///      the left end included and the right one not: the pixel that holds the point of the side there. A steeper one
///      gives one for each row, the upper end included and the lower one not. The depth is affine along the side,
///      colours are perspective-correct;
///    - `point`: for each of the same sides the pixel that holds the corner where it begins, in the polygon's order,
///      rounded likewise.
/// 6. Only pixels of the viewport are drawn, in all modes: what lies exactly on its right or lower border is not.
/// 7. Fragments of the picture are tested and written (draw_fragments). The last corner of the *triangle* gives the
/// flat colour.
///
/// Indices are less than the number of vertices; triangles with NaN or infinity draw nothing. The layer's two grids
/// have one size. Guarantee of the reference: every stage as exact as its unit's; two triangles that share a side leave
/// no pixel out and draw none twice
/// (`fill`), also where they are clipped.
/// Course: the stages of the pipeline, viewport transformation, face culling, polygon modes.
void draw_triangles(const PipelineState& state, std::span<const ColoredVertex> vertices,
                    std::span<const glm::uvec3> triangles, Layer& target);

}
