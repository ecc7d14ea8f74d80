#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/ray.hpp>
#include <umbral/projections/view_frame.hpp>
#include <umbral/projections/view_volume.hpp>

namespace umbral::interaction {

/// The pixel of the framebuffer under the cursor: column from the left, row from the **top**, both from 0. Nothing if
/// the cursor is outside of the window's contents.
///
/// `cursor` is what GLFW tells: in screen coordinates, (0, 0) the upper left corner of the contents, x to the right, y
/// down, with fractions; negative, or beyond `window`, while the user drags outside. `window` is the size of the
/// contents in screen coordinates (glfwGetWindowSize), `framebuffer` their size in pixels (glfwGetFramebufferSize);
/// each pixel is as wide as window.x / framebuffer.x screen coordinates, and as high as window.y / framebuffer.y. A
/// pixel owns its left and its upper border. Nothing, too, if one of the sizes is 0, as of a minimised window, or if
/// the cursor is NaN.
/// Guarantee of the reference: right wherever the cursor is 1e-9 pixels or more from a border between pixels; and on
/// the borders, where cursor * framebuffer is exact in double. Course: FGE_BotonRaton, glfwGetCursorPos.
[[nodiscard]] std::optional<glm::ivec2> pick_pixel(const glm::dvec2& cursor, const glm::ivec2& window,
                                                   const glm::ivec2& framebuffer);

/// A perspective view and its picture. Course: o_ec, x_ec, y_ec, z_ec; l, r, b, t, n, f; w columns and h rows.
struct PickView {
    projections::ViewFrame frame;     ///< in world coordinates; the camera looks along -z, its eye is the origin
    projections::ViewVolume frustum;  ///< 0 < near_plane < far_plane, which may be infinite; sides as they are
    glm::ivec2 picture;               ///< columns and rows, both > 0: it shows the whole frustum
};

/// The ray from the eye through the **centre** of a pixel (column from the left, row from the top), in world
/// coordinates: what it meets first is what the pixel shows. `pixel` may lie outside of the picture, which goes on
/// there.
///
/// `direction` is a unit vector. `t_min` and `t_max` are where the ray passes the near plane and the far plane: only
/// what lies between them is seen, and can be picked.
/// Guarantee of the reference, for all pixels: the origin is the eye, each component of the direction is the exact one
/// for the view's numbers within 6e-8, t_min and t_max within 1 ulp. Course: problem 4.3.
[[nodiscard]] Ray pick_ray(const PickView& view, const glm::ivec2& pixel);

}
