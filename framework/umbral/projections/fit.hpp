#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/projections/view_volume.hpp>

namespace umbral::projections {

/// Width and height of a picture in pixels, both positive.
struct PictureSize {
    int width;
    int height;
};

/// The tightest frustum for a cube that the camera sees head-on: the eye lies `distance` from the cube's middle, on the
/// line through it that is perpendicular to a face. Edges of length `side` > 0; distance > side / 2.
///
/// Nothing of the cube is clipped, it appears as large as it can, near_plane is as large and far_plane as small as
/// possible, and pixels are square: (right - left) / (top - bottom) is width / height. Throws std::invalid_argument if
/// a number is not in its range. Guarantee of the reference, for this and the functions below: every number is the
/// exact one rounded to float once, but for a part in 10^9. Course: problems 3.5 (distance side + 2) and 3.7.
[[nodiscard]] ViewVolume fit_cube(float side, float distance, const PictureSize& picture);

/// The same for a sphere: radius > 0, distance > radius. The widest part of it that is seen lies behind the near plane
/// and before its middle: where rays from the eye touch it. Course: problem 3.6.
[[nodiscard]] ViewVolume fit_sphere(float radius, float distance, const PictureSize& picture);

/// A frustum, and where its eye is in the world; it looks along the world's -z.
struct PlacedVolume {
    glm::vec3 eye;
    ViewVolume volume;
};

/// The tightest frustum for a cube if the vertical field of view is given instead of the distance: the eye lies on the
/// line through the cube's middle that is parallel to z, on the side of larger z. side > 0, 0 < fovy_degrees < 180;
/// else it throws std::invalid_argument. Course: problem 3.8.
[[nodiscard]] PlacedVolume fit_cube_to_fovy(const glm::vec3& centre, float side, float fovy_degrees,
                                            const PictureSize& picture);

}
