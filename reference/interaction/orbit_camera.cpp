// Based on: the course's orbital camera, V = Tra(0,0,-d) · Rot(pitch, X) · Rot(-yaw, Y) · Tra(-target).

#include <umbral/interaction/orbit_camera.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbral::interaction {
namespace {

constexpr double zoom_step = 1.1;

/// Angles are counted in half turns: π does not come in before the matrix, so that a whole number of turns is taken off
/// exactly, however many there were. Double throughout: a rounding in it is 1e-16 of a half turn, and a session has
/// fewer events than it would take to see them.
class ReferenceCamera final : public OrbitCamera {
public:
    explicit ReferenceCamera(const OrbitCameraSettings& settings)
        : settings_(settings), max_pitch_(settings.max_pitch / std::numbers::pi), height_(settings.viewport_height)
    {
        begin();
    }

    void drag(double right, double up) override
    {
        if (!std::isfinite(right) || !std::isfinite(up)) return;
        yaw_ = std::remainder(yaw_ - right / height_, 2.0);
        pitch_ = std::clamp(pitch_ - up / height_, -max_pitch_, max_pitch_);
    }

    void scroll(double steps) override
    {
        if (!std::isfinite(steps)) return;
        distance_ = std::clamp(distance_ * std::pow(zoom_step, -steps), settings_.min_distance, settings_.max_distance);
    }

    void resize(int width, int height) override
    {
        if (width > 0 && height > 0) height_ = height;
    }

    void reset() override { begin(); }

    [[nodiscard]] glm::mat4 view() const override
    {
        const double sy = std::sin(yaw_ * std::numbers::pi);
        const double cy = std::cos(yaw_ * std::numbers::pi);
        const double sp = std::sin(pitch_ * std::numbers::pi);
        const double cp = std::cos(pitch_ * std::numbers::pi);

        // The camera's axes in world coordinates: the rows of the rotation. z goes from the target to the camera.
        const glm::dvec3 x(cy, 0, -sy);
        const glm::dvec3 y(-sp * sy, cp, -sp * cy);
        const glm::dvec3 z(cp * sy, sp, cp * cy);
        const glm::dvec3& t = settings_.target;
        return glm::mat4(glm::dmat4(x.x, y.x, z.x, 0,  //
                                    x.y, y.y, z.y, 0,  //
                                    x.z, y.z, z.z, 0,  //
                                    -dot(x, t), -dot(y, t), -dot(z, t) - distance_, 1));
    }

private:
    void begin()
    {
        yaw_ = settings_.yaw / std::numbers::pi;
        pitch_ = settings_.pitch / std::numbers::pi;
        distance_ = settings_.distance;
    }

    OrbitCameraSettings settings_;
    double max_pitch_;
    double height_;  ///< of the viewport: so many pixels are a half turn
    double yaw_ = 0;
    double pitch_ = 0;
    double distance_ = 0;
};

}

std::unique_ptr<OrbitCamera> make_orbit_camera(const OrbitCameraSettings& settings)
{
    return std::make_unique<ReferenceCamera>(settings);
}

}
