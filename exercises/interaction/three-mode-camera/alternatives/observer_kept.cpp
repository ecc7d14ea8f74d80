// alternative: keeps the observer instead of the attention point, and looks from there with GLM, with an up vector that
// has a direction at the poles too
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/interaction/three_mode_camera.hpp>

namespace umbral::interaction {
namespace {

struct WalkingCamera : ThreeModeCamera {
    explicit WalkingCamera(const ThreeModeSettings& s)
        : limits(s), now(s.mode), alpha(s.azimuth), beta(s.elevation), r(s.distance), eye(s.attention + r * back())
    {
    }

    void move_xy(double right, double up) override
    {
        if (!std::isfinite(right + up)) return;
        if (now == CameraMode::move) {
            eye = eye + right * glm::cross(above(), back()) + up * above();
            return;
        }
        const glm::dvec3 centre = attention_point();
        alpha += right;
        beta = glm::clamp(beta + up, -glm::half_pi<double>(), glm::half_pi<double>());
        if (now == CameraMode::examine) eye = centre + r * back();
    }
    void move_z(double steps) override
    {
        if (std::isnan(steps) || std::isinf(steps)) return;
        if (now == CameraMode::examine) {
            const glm::dvec3 centre = attention_point();
            const double before = r - limits.min_distance;
            stand_off(limits.min_distance + before * std::exp(steps * std::log1p(limits.zoom_step)));
            eye = centre + r * back();
        } else {
            eye += steps * back();
        }
    }
    void look_toward(const glm::dvec3& point) override
    {
        const double far = glm::length(eye - point);
        if (!std::isfinite(far) || far < 1e-6) return;
        const glm::dvec3 direction = (eye - point) / far;
        if (glm::length(glm::dvec2(direction.x, direction.z)) >= 1e-6) alpha = std::atan2(direction.x, direction.z);
        beta = std::atan2(direction.y, std::sqrt(direction.x * direction.x + direction.z * direction.z));
        stand_off(far);
        now = CameraMode::examine;
    }
    void next_mode() override
    {
        now = now == CameraMode::examine ? CameraMode::move
              : now == CameraMode::move  ? CameraMode::turn
                                         : CameraMode::examine;
    }
    CameraMode mode() const override { return now; }
    glm::dvec3 attention_point() const override { return eye - r * back(); }
    glm::mat4 view() const override
    {
        const glm::dmat4 around = glm::lookAt(glm::dvec3(0), -back(), above());
        return glm::mat4(glm::translate(around, -eye));
    }

    glm::dvec3 back() const
    {
        return {std::cos(beta) * std::sin(alpha), std::sin(beta), std::cos(beta) * std::cos(alpha)};
    }
    glm::dvec3 above() const
    {
        return {-std::sin(beta) * std::sin(alpha), std::cos(beta), -std::sin(beta) * std::cos(alpha)};
    }
    void stand_off(double distance)
    {
        r = std::fmin(std::fmax(distance, 1.001 * limits.min_distance), limits.max_distance);
    }

    const ThreeModeSettings limits;
    CameraMode now;
    double alpha, beta, r;
    glm::dvec3 eye;
};

}

std::unique_ptr<ThreeModeCamera> make_three_mode_camera(const ThreeModeSettings& settings)
{
    return std::make_unique<WalkingCamera>(settings);
}

}
