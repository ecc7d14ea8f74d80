#pragma once

#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>
#include <umbral/core/not_implemented.hpp>

namespace umbral::texturing {

/// What a texture has between the centres of its texels: the colour of the texel that owns the place, or a blend of the
/// four nearest centres.
enum class Filter { nearest, bilinear };

/// What lies outside the unit square: the texture again and again, or its outermost texels drawn out for ever.
enum class Wrap { repeat, clamp_to_edge };

struct Sampler {
    Filter filter = Filter::nearest;
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
};

/// The colour of a texture of at least one texel at (u, v).
///
/// **v goes up**: (0, 0) is the lower left corner of the picture as one sees it, (1, 1) the upper right one. A grid's
/// row 0 is the top row, so it lies at v = 1. (The course, like OpenGL, keeps the bottom row first in memory; (0, 0) is
/// the lower left corner there too.) With n columns, texel i owns i/n <= u < (i+1)/n and has its centre at (i + ½)/n;
/// rows likewise, counted from the bottom. Blends wrap each neighbour for itself: with repeat, the last texel's
/// neighbour is the first one. NaN counts as 0, and so does an infinite coordinate with repeat, which has no fraction.
/// Guarantee of the reference, for textures of up to 16384 x 16384: which texels it reads is exact for every float u
/// and v; the fractions between them are off by half an ulp at most. It throws std::invalid_argument if the texture has
/// no texel. Course: section C 1.8, "consulta de texels: más cercano, interpolación bilineal"; "replicado,
/// truncamiento".
[[nodiscard]] glm::vec4 lookup(const Grid<glm::vec4>& texture, const Sampler& sampler, glm::vec2 uv);

}
