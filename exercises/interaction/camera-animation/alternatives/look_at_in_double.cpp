// alternative: GLM's look-at in double round the observer, with an up vector chosen beforehand
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>
#include <umbral/interaction/camera_animation.hpp>

namespace umbral::interaction {
namespace {

struct Now {
    glm::dvec3 eye;
    glm::dvec3 target;
};

Now at(const CameraFlight& f, double t)
{
    const double s = f.duration;
    if (std::isnan(t) || std::isnan(s) || std::isinf(s) || s < 0) throw std::invalid_argument("time or duration");
    const double u = s > 0 ? std::clamp(t, 0.0, s) / s : (t < 0 ? 0.0 : 1.0);
    return {glm::mix(glm::dvec3(f.eye_from), glm::dvec3(f.eye_to), u),
            glm::mix(glm::dvec3(f.target_from), glm::dvec3(f.target_to), u)};
}

}

FlightPose flight_pose(const CameraFlight& flight, float seconds)
{
    const Now now = at(flight, seconds);
    return {glm::vec3(now.eye), glm::vec3(now.target)};
}

glm::mat4 flight_view(const CameraFlight& flight, float seconds)
{
    const Now now = at(flight, seconds);
    glm::dvec3 forward = now.target - now.eye;
    if (glm::length(forward) < 1e-6) forward = {0, 0, -1};
    forward = glm::normalize(forward);
    glm::dvec3 up(0, 1, 0);
    if (std::hypot(forward.x, forward.z) < 1e-6)
        up = std::abs(forward.x) <= std::abs(forward.z) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    return glm::mat4(glm::translate(glm::lookAt(glm::dvec3(0), forward, up), -now.eye));
}

}
