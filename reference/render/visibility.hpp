#pragma once

#include <glm/glm.hpp>

#include "render/draw_list.hpp"

namespace umbral::render {

/// How far beyond the picture the rasteriser takes triangles, as a factor of w: clip coordinates with |x|, |y| <=
/// guard_band · w give window positions within what rasterize_triangle promises. Only what reaches further is clipped
/// at the sides: clipping makes new vertices, which are rounded to the subpixel grid and so bend edges. Powers of two,
/// so that scaling by them is exact.
[[nodiscard]] glm::vec2 guard_band(int width, int height);

/// Classifies a mesh by the box round it. Errs towards `crosses`: by more than what rounding does to single vertices.
[[nodiscard]] Visibility visibility(const VertexMesh& mesh, const glm::mat4& to_clip, const glm::vec2& guard);

}
