#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/grid.hpp>
#include <umbral/core/not_implemented.hpp>

namespace umbral::projections {

/// What a viewer with two eyes looks at: a screen, a window into the scene. Lengths are in the units of the scene, and
/// finite but for the far plane: no more than the ranges here has to be checked.
///
/// The head's coordinates: the origin midway between the eyes, which lie at x = -eye_separation / 2 (left) and
/// eye_separation / 2 (right); the screen's middle at (0, 0, -distance), its sides parallel to x and y.
struct StereoScreen {
    float width;           ///< more than 0
    float height;          ///< more than 0
    float distance;        ///< from the eyes to the screen, more than 0. Course: distancia de convergencia
    float eye_separation;  ///< more than 0. Course: distancia interocular
    float near_plane;      ///< distance of the near plane from each eye, more than 0
    float far_plane;       ///< distance of the far plane from each eye, more than near_plane; may be infinite
};

/// The matrices of one eye. Column vectors, column-major storage.
struct EyeMatrices {
    glm::mat4 view;        ///< from the head's coordinates to those of this eye, which looks along its own -z
    glm::mat4 projection;  ///< from the eye's coordinates to OpenGL's clip coordinates, as frustum_matrix: w = -z
};

struct StereoPair {
    EyeMatrices left;
    EyeMatrices right;
};

/// Parallel axes: both eyes look along the head's -z, and the frustum of each goes through the borders of the screen.
///
/// So a point of the screen appears in the same place in both pictures. Throws std::invalid_argument if a number of the
/// screen is not in the range that `StereoScreen` gives for it, or is NaN. Guarantee of the reference, here and for
/// toe-in: every entry is the exact one rounded to float once, but for a part in 10^8. Course: estéreo OFF-AXIS.
[[nodiscard]] StereoPair off_axis_pair(const StereoScreen& screen);

/// Convergent axes: each eye is turned about its y axis until it looks at the screen's middle. Its frustum is
/// symmetric, and goes through the borders of a window of the screen's width and height round that point,
/// perpendicular to this eye's axis.
///
/// Throws as off_axis_pair does. Course: estéreo TOE-IN.
[[nodiscard]] StereoPair toe_in_pair(const StereoScreen& screen);

/// How much farther to the right a point appears to the right eye than to the left one, measured on the screen, under
/// off-axis projection. `distance` is the point's depth before the eyes, -z, more than 0; it may be infinite.
///
/// Positive behind the screen, zero on it, negative before it. Throws std::invalid_argument if the distance is not in
/// its range; of the screen, which nothing checks here, only distance and eye_separation count. Guarantee of the
/// reference, here and below: the exact number rounded to float once, but for a part in 10^8. Course: paralaje
/// positivo, negativo y cero.
[[nodiscard]] float parallax(const StereoScreen& screen, float distance);

/// The inverse: the distance at which a point has this parallax. Infinite if the parallax is the eyes' separation;
/// nothing if it is larger, since then the two lines of sight do not meet before the viewer. The parallax is not NaN,
/// and of the screen, which nothing checks here, only distance and eye_separation count.
[[nodiscard]] std::optional<float> distance_of_parallax(const StereoScreen& screen, float parallax);

/// Where the right eye sees a point less where the left eye sees it, in normalised device coordinates; nothing if the
/// point's w is 0 or negative for one eye or for both. The point is in the head's coordinates. The eyes may
/// stand and look anywhere; their projections are as `EyeMatrices` says, with w = -z.
///
/// y is the vertical parallax, which no eye can follow: it is 0 for all points under off-axis projection. Guarantee of
/// the reference: within 1e-15 times the sum of the terms' sizes over w, and one rounding to float.
[[nodiscard]] std::optional<glm::vec2> disparity(const StereoPair& pair, const glm::vec3& point);

/// What an anaglyph keeps of the colours.
enum class AnaglyphColors {
    full,  ///< red is the left picture's red
    half,  ///< red is the left picture's luminance, so that red things do not flicker between the eyes
    gray   ///< red is the left picture's luminance, green and blue are the right picture's luminance
};

/// One picture for red-cyan glasses: red is for the left eye, which looks through the red glass, green and blue for the
/// right eye. Where nothing else is said, green and blue are those of the right picture.
///
/// Luminance is 0.2126 R + 0.7152 G + 0.0722 B of **linear** light, and is stored encoded by the sRGB curve, rounded
/// to the nearest code. The pictures are sRGB; alpha of the result is 255. Throws std::invalid_argument if their sizes
/// differ. Course: anaglifos.
[[nodiscard]] Image anaglyph(const Image& left, const Image& right, AnaglyphColors colors);

}
