#include <umbral/interaction/camera_animation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "wide.hpp"

// Everything in 113 bits, coordinate by coordinate, and rounded once.

namespace umbral::interaction {
namespace {

using Triple = std::array<Wide, 3>;

Wide dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Triple cross(const Triple& a, const Triple& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Triple unit(const Triple& v)
{
    const Wide length = square_root(dot(v, v));
    return {v[0] / length, v[1] / length, v[2] / length};
}

Triple place(const glm::vec3& from, const glm::vec3& to, const CameraFlight& flight, float seconds)
{
    if (std::isnan(seconds) || !std::isfinite(flight.duration) || flight.duration < 0)
        throw std::invalid_argument("no such time or duration");
    Triple result;
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

glm::vec3 rounded(const Triple& v)
{
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

Wide size_of(Wide value) { return value < 0 ? -value : value; }

/// The world axis with the smallest share of the direction.
Triple flattest(const Triple& z)
{
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (size_of(z[i]) < size_of(z[least])) least = i;
    Triple axis{0, 0, 0};
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
    const Triple eye = place(flight.eye_from, flight.eye_to, flight, seconds);
    const Triple target = place(flight.target_from, flight.target_to, flight, seconds);
    Triple back{eye[0] - target[0], eye[1] - target[1], eye[2] - target[2]};
    if (dot(back, back) < Wide(1e-12)) back = {0, 0, 1};
    const Triple z = unit(back);
    const Wide flat = z[0] * z[0] + z[2] * z[2];
    const Triple x = unit(cross(flat < Wide(1e-12) ? flattest(z) : Triple{0, 1, 0}, z));
    glm::mat4 view(1);
    int row = 0;
    for (const Triple& axis : {x, cross(z, x), z}) {
        for (int column = 0; column < 3; ++column) view[column][row] = static_cast<float>(axis[column]);
        view[3][row] = static_cast<float>(-dot(axis, eye));
        ++row;
    }
    return view;
}

}
