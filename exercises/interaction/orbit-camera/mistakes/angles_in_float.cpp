// mistake: adds up angles and distance in float
// credit: 72..86
// hint: After a hundred thousand drags the rounding of each float addition adds up to degrees. Keep angles and distance
// in double, and take off whole turns.
#include <cmath>
#include <umbral/interaction/orbit_camera.hpp>

namespace umbral::interaction {
namespace {

constexpr double pi = 3.14159265358979323846;

class FloatCamera : public OrbitCamera {
public:
    explicit FloatCamera(const OrbitCameraSettings& settings) : settings_(settings), height_(settings.viewport_height)
    {
        reset();
    }

    void drag(double right, double up) override
    {
        if (!std::isfinite(right) || !std::isfinite(up)) return;
        const auto limit = static_cast<float>(settings_.max_pitch);
        yaw_ = std::fmod(yaw_ - static_cast<float>(pi * right / height_), static_cast<float>(2 * pi));
        pitch_ = glm::clamp(static_cast<float>(pitch_ - pi * up / height_), -limit, limit);
    }
    void scroll(double steps) override
    {
        if (!std::isfinite(steps)) return;
        distance_ = static_cast<float>(
            glm::clamp(distance_ * std::pow(1.1, -steps), settings_.min_distance, settings_.max_distance));
    }
    void resize(int width, int height) override
    {
        if (width > 0 && height > 0) height_ = height;
    }
    void reset() override
    {
        yaw_ = static_cast<float>(settings_.yaw);
        pitch_ = static_cast<float>(settings_.pitch);
        distance_ = static_cast<float>(settings_.distance);
    }
    [[nodiscard]] glm::mat4 view() const override
    {
        // From here on in double, so that nothing but the sums is to blame.
        const double a = yaw_;
        const double b = pitch_;
        const glm::dvec3 x(std::cos(a), 0, -std::sin(a));
        const glm::dvec3 z(std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a));
        const glm::dmat3 axes(x, cross(z, x), z);
        glm::dmat4 view(transpose(axes));
        view[3] = glm::dvec4(-(settings_.target * axes) - glm::dvec3(0, 0, distance_), 1);
        return glm::mat4(view);
    }

private:
    OrbitCameraSettings settings_;
    int height_;
    float yaw_ = 0;
    float pitch_ = 0;
    float distance_ = 0;
};

}

std::unique_ptr<OrbitCamera> make_orbit_camera(const OrbitCameraSettings& settings)
{
    return std::make_unique<FloatCamera>(settings);
}

}
