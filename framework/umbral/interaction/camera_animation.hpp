#pragma once

#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>

namespace umbral::interaction {

/// A camera that flies: observer and attention point each go from one place to another, in a straight line, at constant
/// speed, and both arrive after `duration` seconds.
struct CameraFlight {
    glm::vec3 eye_from{0};
    glm::vec3 eye_to{0};
    glm::vec3 target_from{0};
    glm::vec3 target_to{0};
    float duration = 1;  ///< seconds, finite, >= 0
};

/// Where the camera stands, and what it looks at.
struct FlightPose {
    glm::vec3 eye;
    glm::vec3 target;
};

/// Where the camera of a flight is, so many seconds after its beginning: at its beginning for negative times, and at
/// its end from `duration` on, exactly. A flight of no duration is at its end at 0 seconds.
///
/// It follows from the arguments alone: times may come in any order, ±infinity too. Throws std::invalid_argument if the
/// duration is negative, infinite or NaN, or if the time is NaN. Guarantee of the reference: every coordinate is the
/// exact one rounded to float once, but for a part in 10^12 of the larger of the two that it lies between. Course:
/// problem 4.1, o(t) and a(t).
[[nodiscard]] FlightPose flight_pose(const CameraFlight& flight, float seconds);

/// The view matrix at that time, with the world's y axis up in the picture: V = MAT_LookAt(o(t), a(t), (0, 1, 0)).
/// Column vectors; the camera looks along its -z. Throws as above.
///
/// Where it looks along the y axis (the sine of the angle between them is below 1e-6), the world axis that is most
/// perpendicular to the view is up instead (of equals, the first of x, y, z). Where observer and attention point are
/// nearer to each other than 1e-6, it looks along the world's -z. Guarantee of the reference, for places up to 1e6 from
/// the origin: rotation within 2e-7 in every entry and translation within 3e-7 of |o(t)|, for any distance between them
/// from 1e-5 and from 1e-8 of the farthest of the four places on: so o(t) - a(t) is not computed from places rounded to
/// float. Course: problem 4.1.
[[nodiscard]] glm::mat4 flight_view(const CameraFlight& flight, float seconds);

}
