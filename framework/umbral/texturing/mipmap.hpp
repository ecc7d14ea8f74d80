#pragma once

#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/texturing/lookup.hpp>
#include <vector>

namespace umbral::texturing {

/// A texture in all its sizes: level 0 is the texture itself, and each further level has half as many columns and rows.
using Mipmap = std::vector<Grid<glm::vec4>>;

/// The n + 1 levels of a texture of 2^n x 2^n texels, n >= 0, down to a single texel. Each texel is the mean of the
/// four in the level before that cover the same place: M'[j, k] = (M[2j, 2k] + M[2j+1, 2k] + M[2j, 2k+1] + M[2j+1,
/// 2k+1]) / 4. Texels are light, or whatever may be averaged, so nothing is decoded. Right to 4 ulp of the largest
/// texel. Throws std::invalid_argument unless the texture is square and its size a power of two. Course: slides F2,
/// "creación".
[[nodiscard]] Mipmap build_mipmap(const Grid<glm::vec4>& texture);

/// The level for a surface at a distance, where `near` > 0 is the distance at which a texel is as large as a pixel: 0
/// up to there, and 1 more with each doubling, log2(distance / near). Not limited by the number of levels. Finite
/// positive distances, also where the quotient overflows. Right to 1e-6, or 2 ulp of the level, log2(distance) or
/// log2(near): a difference of logarithms in float will do. Guarantee of the reference: 1 ulp or 1e-15. Course: slides
/// F3, "acceso".
[[nodiscard]] float level_at_distance(float distance, float near);

/// The level for a pixel from the derivatives of (u, v) by the pixel's x and y, for a texture of `size` columns and
/// rows: the log2 of the longer of the two steps, measured in texels (u times the columns, v times the rows), but at
/// least 0, also where both steps are 0. Not limited by the number of levels. Finite derivatives, also where squares
/// overflow. Right to 1e-6 or 2 ulp. Guarantee of the reference: 1 ulp or 1e-15. This is OpenGL's choice.
[[nodiscard]] float level_of_step(glm::vec2 by_x, glm::vec2 by_y, glm::ivec2 size);

/// The colour at (u, v), repeated, in a mipmap of at least one level: bilinear lookups in the two levels round `level`,
/// blended by its fraction. Below 0 it is level 0, from the list's last level on it is that one. Course: slides F3,
/// "interpolar entre las dos texturas más adecuadas".
[[nodiscard]] glm::vec4 trilinear(const Mipmap& mipmap, glm::vec2 uv, float level);

}
