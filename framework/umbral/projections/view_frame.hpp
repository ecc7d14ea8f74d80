#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>

namespace umbral::projections {

/// A view as the course writes it down: the point looked at (ȧ), a vector that shall appear vertical (u⃗, VUP), and the
/// vector from that point to the eye (n⃗, VPN).
struct ViewParameters {
    glm::vec3 target;
    glm::vec3 up;
    glm::vec3 normal;
};

/// A camera's frame in world coordinates: unit axes, perpendicular and right-handed, x to the right of the picture, y
/// up, z towards the viewer; and the eye.
struct ViewFrame {
    glm::vec3 x;
    glm::vec3 y;
    glm::vec3 z;
    glm::vec3 origin;
};

/// The frame of a view: z along `normal`, x perpendicular to `up` and z, y on the side of `up`, the origin at target +
/// normal. Vectors may have any length.
///
/// Nothing if there is no such frame: `up` or `normal` is zero, or the sine of the angle between them is below 1e-6.
/// Guarantee of the reference: every component of an axis within 6e-8 of the exact one, down to a sine of 2e-6; the
/// origin rounded once. Course: problem 3.3.
[[nodiscard]] std::optional<ViewFrame> view_frame(const ViewParameters& view);

/// The view of `target` from `distance` (> 0) away. The azimuth says from which side: 0° from the +z side, 90° from the
/// +x side; the elevation from how high: 0° from as high as the target, 90° from straight above. The world's y axis
/// appears turned anticlockwise from the vertical by the roll.
///
/// `up` of the result is the unit vector that points up in the picture, perpendicular to `normal`; so it exists for
/// views from straight above and below too. Angles are in degrees, of any size. Guarantee of the reference: components
/// within 6e-8 of the vector's length, for angles up to 1e6. Course: problems 3.1 (azimuth 45°) and 3.2 (and roll 45°).
[[nodiscard]] ViewParameters view_from(const glm::vec3& target, float distance, float azimuth_degrees,
                                       float elevation_degrees, float roll_degrees);

}
