// Based on: the course's problem 4.1; its text lets the flight end at t = 1 and also after s seconds: it is the latter.

#include <umbral/interaction/camera_animation.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <umbral/projections/view.hpp>

namespace umbral::interaction {
namespace {

constexpr double same_place = 1e-6;

/// How much of the flight is over: 0 to 1.
double part_of(const CameraFlight& flight, float seconds)
{
    if (!(flight.duration >= 0) || std::isinf(flight.duration))
        throw std::invalid_argument("a flight's duration must be at least 0, and finite");
    if (std::isnan(seconds)) throw std::invalid_argument("a time must be a number");
    // Before a division by a duration of 0.
    if (seconds >= flight.duration) return 1;
    return seconds <= 0 ? 0 : double{seconds} / flight.duration;
}

/// Exactly `from` at 0 and `to` at 1, and never off by more than rounding, which from + u (to - from) is.
glm::dvec3 between(const glm::vec3& from, const glm::vec3& to, double u)
{
    return (1 - u) * glm::dvec3(from) + u * glm::dvec3(to);
}

}

FlightPose flight_pose(const CameraFlight& flight, float seconds)
{
    const double u = part_of(flight, seconds);
    return {glm::vec3(between(flight.eye_from, flight.eye_to, u)),
            glm::vec3(between(flight.target_from, flight.target_to, u))};
}

// Turned first, where it stands, and moved afterwards: only the way from the observer to the attention point must be
// rounded to float for that, and it keeps its digits however far from the origin both are.
glm::mat4 flight_view(const CameraFlight& flight, float seconds)
{
    const double u = part_of(flight, seconds);
    const glm::dvec3 eye = between(flight.eye_from, flight.eye_to, u);
    const glm::dvec3 way = between(flight.target_from, flight.target_to, u) - eye;
    const glm::vec3 seen = length(way) < same_place ? glm::vec3(0) : glm::vec3(way);
    glm::dmat4 view(projections::view_matrix(glm::vec3(0), seen, {0, 1, 0}));
    view[3] = glm::dvec4(-(glm::dmat3(view) * eye), 1);
    return glm::mat4(view);
}

}
