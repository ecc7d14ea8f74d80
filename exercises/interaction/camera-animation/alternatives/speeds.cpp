// alternative: velocities times time, in long double, seen from whichever end is nearer in time; the observer is
// subtracted by a translation
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>
#include <umbral/interaction/camera_animation.hpp>
#include <umbral/projections/view.hpp>

namespace umbral::interaction {
namespace {

using Long3 = glm::vec<3, long double>;

Long3 moved(const glm::vec3& from, const glm::vec3& to, long double t, long double s)
{
    if (t >= s) return Long3(to);
    if (t <= 0) return Long3(from);
    const Long3 velocity = (Long3(to) - Long3(from)) / s;
    return 2 * t < s ? Long3(from) + t * velocity : Long3(to) - (s - t) * velocity;
}

void check(const CameraFlight& flight, float seconds)
{
    const bool good = flight.duration >= 0 && flight.duration <= 3.402823466e38F && !std::isnan(seconds);
    if (!good) throw std::invalid_argument("no such flight");
}

}

FlightPose flight_pose(const CameraFlight& flight, float seconds)
{
    check(flight, seconds);
    return {glm::vec3(moved(flight.eye_from, flight.eye_to, seconds, flight.duration)),
            glm::vec3(moved(flight.target_from, flight.target_to, seconds, flight.duration))};
}

glm::mat4 flight_view(const CameraFlight& flight, float seconds)
{
    check(flight, seconds);
    const Long3 eye = moved(flight.eye_from, flight.eye_to, seconds, flight.duration);
    Long3 way = moved(flight.target_from, flight.target_to, seconds, flight.duration) - eye;
    if (dot(way, way) < 1e-12L) way = {0, 0, -1};
    const glm::mat4 turn = projections::view_matrix({0, 0, 0}, glm::vec3(way), {0, 1, 0});
    return glm::mat4(glm::translate(glm::dmat4(turn), -glm::dvec3(eye)));
}

}
