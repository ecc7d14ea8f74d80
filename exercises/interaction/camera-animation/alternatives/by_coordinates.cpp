// alternative: every coordinate on its own by std::lerp, and the rows of the matrix written out
#include <cmath>
#include <stdexcept>
#include <umbral/interaction/camera_animation.hpp>

namespace umbral::interaction {
namespace {

double fraction(float t, float s)
{
    if (t != t) throw std::invalid_argument("flight: the time is not a number");
    if (!std::isfinite(s) || s < 0.0F) throw std::invalid_argument("flight: the duration is negative or not finite");
    if (t < 0) return 0;
    if (t >= s) return 1;
    return static_cast<double>(t) / static_cast<double>(s);
}

void place(const glm::vec3& a, const glm::vec3& b, double u, double (&out)[3])
{
    for (int i = 0; i < 3; ++i) out[i] = std::lerp(static_cast<double>(a[i]), static_cast<double>(b[i]), u);
}

}

FlightPose flight_pose(const CameraFlight& flight, float seconds)
{
    const double u = fraction(seconds, flight.duration);
    double o[3], a[3];
    place(flight.eye_from, flight.eye_to, u, o);
    place(flight.target_from, flight.target_to, u, a);
    return {glm::vec3(o[0], o[1], o[2]), glm::vec3(a[0], a[1], a[2])};
}

glm::mat4 flight_view(const CameraFlight& flight, float seconds)
{
    const double u = fraction(seconds, flight.duration);
    double o[3], a[3];
    place(flight.eye_from, flight.eye_to, u, o);
    place(flight.target_from, flight.target_to, u, a);
    double z[3] = {o[0] - a[0], o[1] - a[1], o[2] - a[2]};
    double size = std::hypot(z[0], z[1], z[2]);
    if (size < 1e-6) {
        z[0] = z[1] = 0;
        z[2] = size = 1;
    }
    for (double& c : z) c /= size;
    // x = (0, 1, 0) × z, or where that is nothing (1, 0, 0) × z or (0, 0, 1) × z.
    double x[3] = {z[2], 0, -z[0]};
    if (std::hypot(z[0], z[2]) < 1e-6) {
        const bool up_is_x = std::abs(z[0]) <= std::abs(z[2]);
        x[0] = up_is_x ? 0 : -z[1];
        x[1] = up_is_x ? -z[2] : z[0];
        x[2] = up_is_x ? z[1] : 0;
    }
    const double length = std::hypot(x[0], x[1], x[2]);
    for (double& c : x) c /= length;
    const double y[3] = {z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]};
    glm::mat4 v(1.0F);
    const double* rows[] = {x, y, z};
    for (int r = 0; r < 3; ++r) {
        double moved = 0;
        for (int c = 0; c < 3; ++c) {
            v[c][r] = static_cast<float>(rows[r][c]);
            moved -= rows[r][c] * o[c];
        }
        v[3][r] = static_cast<float>(moved);
    }
    return v;
}

}
