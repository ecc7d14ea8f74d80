#pragma once

#include "render/draw_list.hpp"
#include "render/frame.hpp"

namespace umbral::render {

/// Draws in software with the light computed at the vertices and interpolated, as OpenGL's fixed function does it:
/// a texture multiplies emission, ambient and diffuse light, and the highlight is added after it; exponents are at most
/// fixed_function_exponent. What the picture of gl-fixed is compared with: plain, without kernels. Based on:
/// H. Gouraud. Continuous Shading of Curved Surfaces. 1971.
[[nodiscard]] Frame draw_with_light_at_vertices(const DrawList& list, int width, int height);

}
