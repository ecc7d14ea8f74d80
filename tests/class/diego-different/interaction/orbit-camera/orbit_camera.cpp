#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/interaction/orbit_camera.hpp>

namespace umbral::interaction {
namespace {

struct LookingCamera : OrbitCamera {
    explicit LookingCamera(const OrbitCameraSettings& s) : begin(s), now(s) {}

    void drag(double right, double up) override
    {
        const double per_pixel = std::acos(-1.0) / now.viewport_height;
        if (!std::isfinite(right + up)) return;
        now.yaw = std::remainder(now.yaw - right * per_pixel, 2 * std::acos(-1.0));
        now.pitch = glm::clamp(now.pitch - up * per_pixel, -begin.max_pitch, begin.max_pitch);
    }
    void scroll(double steps) override
    {
        if (std::isfinite(steps))
            now.distance = glm::clamp(now.distance / std::pow(1.1, steps), begin.min_distance, begin.max_distance);
    }
    void resize(int width, int height) override
    {
        if (width > 0 && height > 0) now.viewport_height = height;
    }
    void reset() override
    {
        const int height = now.viewport_height;
        now = begin;
        now.viewport_height = height;
    }
    glm::mat4 view() const override
    {
        const glm::dvec3 n(std::cos(now.pitch) * std::sin(now.yaw), std::sin(now.pitch),
                           std::cos(now.pitch) * std::cos(now.yaw));
        // Round the target: the camera's place is far too large a number to look from.
        const glm::dmat4 around = glm::lookAt(now.distance * n, glm::dvec3(0), glm::dvec3(0, 1, 0));
        return glm::mat4(glm::translate(around, -now.target));
    }

    const OrbitCameraSettings begin;
    OrbitCameraSettings now;
};

}

std::unique_ptr<OrbitCamera> make_orbit_camera(const OrbitCameraSettings& settings)
{
    return std::make_unique<LookingCamera>(settings);
}

}
