#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>

namespace umbral::interaction {

/// The part of the world that a 2D view shows, in world coordinates; y grows upwards. left != right, bottom != top; a
/// view in which they are exchanged is mirrored.
struct ViewLimits {
    double left = -1;
    double right = 1;
    double bottom = -1;
    double top = 1;
};

/// The points p with normal · p = offset. The normal is not 0, and need not be unit.
struct SnapPlane {
    glm::dvec3 normal{0, 1, 0};
    double offset = 0;
};

/// Two ways to look along an axis at a scene, and the one from the front. All are orthographic.
enum class LinkedView {
    front,  ///< seen from +z: x to the right, y up
    top,    ///< seen from +y: x to the right, -z up
    side,   ///< seen from +x: -z to the right, y up
};

/// The pixel of the framebuffer that lies under a cursor: column and row from the upper left corner, y downwards. A
/// pixel is the square from its upper left corner on. The cursor is in screen coordinates of the window, of which each
/// has framebuffer_size / window_size pixels; outside the window, the pixel lies outside too, and is negative left of
/// it and above. std::nullopt if a size is 0, as that of a minimised window.
[[nodiscard]] std::optional<glm::ivec2> cursor_pixel(glm::dvec2 cursor, glm::ivec2 window_size,
                                                     glm::ivec2 framebuffer_size);

/// Where the **centre** of a pixel lies in the world, in a 2D view that fills a viewport of so many pixels (> 0). The
/// pixel's row counts from the top, and may lie outside. Guarantee of the reference: 1e-12 of the limits.
/// Course: "posicionamiento 2D: transformación lineal".
[[nodiscard]] glm::dvec2 pixel_in_world(glm::ivec2 pixel, const ViewLimits& limits, glm::ivec2 viewport_size);

/// The point of a plane that is seen at the centre of a pixel, through a camera with these matrices (invertible,
/// perspective or orthographic, as OpenGL's, with a finite far plane).
///
/// std::nullopt if there is none: the ray runs along the plane (within 1e-9 rad), or the point is not in front of the
/// observer, which is where the clip coordinate w is positive. Near and far plane cut nothing off, and an orthographic
/// camera sees every point. Guarantee of the reference: 1e-9 of the distance from the observer, divided by the sine of
/// the angle between ray and plane. Course: "restricción a un plano".
[[nodiscard]] std::optional<glm::dvec3> point_on_plane(glm::ivec2 pixel, glm::ivec2 viewport_size,
                                                       const glm::mat4& view, const glm::mat4& projection,
                                                       const SnapPlane& plane);

/// A cursor in 3D after the mouse moved by `motion` (screen coordinates, to the right and **down**) in an orthographic
/// view from the front that fills the window and shows `limits`.
///
/// Which buttons are down (bit 0 left, bit 1 right; others do not count) says where it moves: the left one alone in the
/// plane X-Y, as seen; the right one, or both, in X-Z, where down is towards the observer, +z, as fast as y would go.
/// Without either it stays. Course: "cursor virtual 3D".
[[nodiscard]] glm::dvec3 moved_cursor(const glm::dvec3& cursor, glm::dvec2 motion, unsigned buttons,
                                      const ViewLimits& limits, glm::ivec2 window_size);

/// Where a view shows the cursor: to the right and up. Course: "tres cursores 2D ligados".
[[nodiscard]] glm::dvec2 cursor_in_view(LinkedView view, const glm::dvec3& cursor);

/// The cursor after the user put it somewhere in one of the views; the coordinate that this view does not show stays.
[[nodiscard]] glm::dvec3 cursor_from_view(LinkedView view, glm::dvec2 place, const glm::dvec3& cursor);

/// The angle of a rotation that the user enters: of the way from a reference point to the cursor, against the
/// horizontal, counter-clockwise as seen, in radians, in (-π, π]. Both in screen coordinates, y **downwards**.
/// std::nullopt if both are the same point. Course: "entrada de transformaciones".
[[nodiscard]] std::optional<double> entered_angle(glm::dvec2 reference, glm::dvec2 cursor);

}
