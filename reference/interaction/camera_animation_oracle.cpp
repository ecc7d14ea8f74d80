#include <umbral/interaction/camera_animation.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "wide_vector.hpp"

// Everything in 113 bits, coordinate by coordinate, and rounded once.

namespace umbral::interaction {
namespace {

WideVector place(const glm::vec3& from, const glm::vec3& to, const CameraFlight& flight, float seconds)
{
    if (std::isnan(seconds) || !std::isfinite(flight.duration) || flight.duration < 0)
        throw std::invalid_argument("no such time or duration");
    WideVector result;
    for (int i = 0; i < 3; ++i) {
        if (seconds >= flight.duration)
            result[i] = to[i];
        else if (seconds <= 0)
            result[i] = from[i];
        else
            result[i] = Wide(from[i]) + (Wide(to[i]) - from[i]) * seconds / flight.duration;
    }
    return result;
}

/// The world axis with the smallest share of the direction.
WideVector flattest(const WideVector& z)
{
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (absolute(z[i]) < absolute(z[least])) least = i;
    WideVector axis{0, 0, 0};
    axis[least] = 1;
    return axis;
}

}

FlightPose flight_pose(const CameraFlight& flight, float seconds)
{
    return {rounded(place(flight.eye_from, flight.eye_to, flight, seconds)),
            rounded(place(flight.target_from, flight.target_to, flight, seconds))};
}

glm::mat4 flight_view(const CameraFlight& flight, float seconds)
{
    const WideVector eye = place(flight.eye_from, flight.eye_to, flight, seconds);
    const WideVector target = place(flight.target_from, flight.target_to, flight, seconds);
    WideVector back = eye - target;
    if (dot(back, back) < Wide(1e-12)) back = {0, 0, 1};
    const WideVector z = unit(back);
    const Wide flat = z[0] * z[0] + z[2] * z[2];
    const WideVector x = unit(cross(flat < Wide(1e-12) ? flattest(z) : WideVector{0, 1, 0}, z));
    glm::mat4 view(1);
    int row = 0;
    for (const WideVector& axis : {x, cross(z, x), z}) {
        for (int column = 0; column < 3; ++column) view[column][row] = static_cast<float>(axis[column]);
        view[3][row] = static_cast<float>(-dot(axis, eye));
        ++row;
    }
    return view;
}

}
