#pragma once

#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::raytracing {

/// The picture I and the Z-buffer. `light` is linear and has no upper bound; of depths the smaller is nearer, and
/// infinity stands where nothing has been drawn.
struct GlassFrame {
    Grid<glm::vec3> light;
    Grid<float> depths;
};

/// A point of an opaque surface in a pixel: column and row, its depth, and the light I_m that it sends to the eye.
struct OpaqueFragment {
    glm::ivec2 pixel{0};
    float depth = 0;
    glm::vec3 light{0};
};

/// A point of a transparent surface in a pixel. What is behind it comes through multiplied by k_t M_t: `k_t` in [0, 1]
/// is the fraction that passes, `m_t` the fractions of red, green and blue of it. `light` is I_m, what the surface
/// itself sends to the eye besides.
struct GlassFragment {
    glm::ivec2 pixel{0};
    float depth = 0;
    glm::vec3 light{0};
    float k_t = 1;
    glm::vec3 m_t{1};
};

/// A frame of this size, 0 or more each way, before anything is drawn: everywhere `background`, at infinity.
[[nodiscard]] GlassFrame empty_glass_frame(int width, int height, const glm::vec3& background);

/// Draws opaque fragments, in any order. One is visible if its depth is smaller than the one that the frame has there;
/// then it replaces both light and depth. Of fragments as near as each other the first one stays.
///
/// Here and below: fragments beside the frame, or whose depth is NaN, are passed over.
void draw_opaque(GlassFrame& frame, const std::vector<OpaqueFragment>& fragments);

/// First algorithm: for each fragment that is visible, I = k_t M_t I, in any order. `light` of the fragments is not
/// looked at. A transparent fragment is visible if its depth is smaller than the frame's; it leaves the depth as it is.
/// Course: Z-buffer adapted to transparent surfaces.
void filter_glass(GlassFrame& frame, const std::vector<GlassFragment>& fragments);

/// Second algorithm: for the fragments that are visible, in each pixel from the farthest to the nearest,
/// I = I_m + k_t M_t I. Visible as in filter_glass; the fragments come in any order, and of those as near as each other
/// the one that comes first in the list is taken for the farther one.
///
/// Guarantee of the reference: light is within 2 n ulp of the exact sum in a pixel with n fragments, as long as
/// nothing in it is negative. Course: Z-buffer for transparent and reflecting surfaces.
void blend_glass(GlassFrame& frame, const std::vector<GlassFragment>& fragments);

}
