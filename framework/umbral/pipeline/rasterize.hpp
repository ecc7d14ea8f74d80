#pragma once

#include <array>
#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::pipeline {

/// A vertex after projection, division by w and viewport transform.
struct WindowVertex {
    glm::vec2 position;  ///< in pixels, x to the right and y down: pixel (x, y) covers [x, x+1) x [y, y+1), its centre
                         ///< is (x + ½, y + ½)
    float depth;         ///< 0 at the near plane, 1 at the far plane
    float inverse_w;     ///< 1/w of the clip coordinates, > 0: w is the distance in front of the camera
};

/// One pixel that a triangle covers, and what the triangle is like there.
struct Fragment {
    glm::ivec2 pixel;   ///< (column, row)
    float depth;        ///< at the pixel's centre, affine in window space
    glm::vec3 weights;  ///< perspective-correct: an attribute is weights[0] * a0 + weights[1] * a1 + weights[2] * a2;
                        ///< they sum to 1
};

/// Appends one fragment for each pixel of a picture `width` x `height` that the triangle covers: row by row from the
/// top, each row from the left.
///
/// Positions are rounded to the nearest 1/256 pixel first (ties to even, as Mesa's llvmpipe does), and everything
/// follows from the rounded ones. A pixel is covered if its centre lies inside the triangle, or on a top edge
/// (horizontal, the inside below it) or a left edge (not horizontal, the inside to its right). So triangles that share
/// an edge share no pixel and leave none out. Both orientations are drawn. Triangles without area give nothing; neither
/// do those with a NaN in any number, with an inverse_w that is not positive, or with a position beyond the guard band
/// [-16384, 16384]. `width` and `height` are at most 16384, too. Guarantee of the reference: coverage is exact, in
/// integers; weights and depth are off by less than one ulp. Course: rasterisation ("pixels whose centre the primitive
/// covers"; it leaves ties open), interpolation of attributes.
void rasterize_triangle(const std::array<WindowVertex, 3>& triangle, int width, int height,
                        std::vector<Fragment>& fragments);

}
