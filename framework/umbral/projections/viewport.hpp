#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>

namespace umbral::projections {

/// The rectangle of a window that a picture goes to, in whole pixels, and the range of depths. Window coordinates have
/// x to the right, y up, and their origin at the window's lower left corner. Course: xl, yb, w, h, nd, fd.
struct Viewport {
    int left;              ///< at most 2^22 from 0, as every place in a window
    int bottom;            ///< as left
    int width;             ///< more than 0, at most 2^20
    int height;            ///< as width
    float near_depth = 0;  ///< what depth -1 becomes; may be larger than far_depth
    float far_depth = 1;   ///< what depth 1 becomes; another number than near_depth
};

/// The matrix D that takes normalised device coordinates to window coordinates: x = -1 to the left border and x = 1 to
/// the right one, y = -1 to the lower border and y = 1 to the upper one, z = -1 to near_depth and z = 1 to far_depth.
///
/// Column vectors, column-major storage. Course: matriz de viewport D, glViewport, glDepthRange.
[[nodiscard]] glm::mat4 viewport_matrix(const Viewport& viewport);

/// The point of normalised device coordinates that comes to lie at this one of window coordinates: the inverse.
[[nodiscard]] glm::vec3 ndc_from_window(const Viewport& viewport, const glm::vec3& window);

/// The pixel of the window that a point of normalised device coordinates falls into; nothing if that is none of the
/// viewport's.
///
/// Pixel (i, j) is the i-th from the left and the j-th from below, counted from 0, and owns the half-open square i <= x
/// < i + 1, j <= y < j + 1 of window coordinates: so every point belongs to one pixel, and x = 1 or y = 1 to none of
/// the viewport. What counts is the place (ndc + 1) size / 2 as computed in double; in float many places come to lie on
/// a border.
[[nodiscard]] std::optional<glm::ivec2> pixel_at(const Viewport& viewport, const glm::vec2& ndc);

/// The normalised device coordinates of the middle of a pixel of the window, which may lie outside the viewport.
[[nodiscard]] glm::vec2 pixel_centre(const Viewport& viewport, const glm::ivec2& pixel);

}
