#pragma once

#include <glm/glm.hpp>

namespace umbral::grader {

/// The colour of `share` (0 … 1, clamped; what is no number counts as 1) in the magma map: black, purple, orange, pale
/// yellow.
///
/// Its lightness grows evenly, so that it reads in order for every kind of colour vision and in grey.
/// Based on: S. van der Walt, N. Smith. A Better Default Colormap for Matplotlib. SciPy 2015; in 256 steps, as OpenCV
/// has it.
[[nodiscard]] glm::u8vec4 magma(double share);

}
