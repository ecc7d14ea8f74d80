// alternative: keeps the axes of the view up to date at each event, turned by quaternions made from two angles
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <umbral/interaction/orbit_camera.hpp>

namespace umbral::interaction {
namespace {

constexpr double pi = 3.14159265358979323846;

class AxesCamera : public OrbitCamera {
public:
    explicit AxesCamera(const OrbitCameraSettings& settings) : first_(settings), pixels_(settings.viewport_height)
    {
        reset();
    }

    void drag(double right, double up) override
    {
        if (!(std::abs(right) <= 1e308 && std::abs(up) <= 1e308)) return;
        double yaw = yaw_ - pi * right / pixels_;
        yaw -= 2 * pi * std::floor(yaw / (2 * pi));
        turn_to(yaw, pitch_ - pi * up / pixels_);
    }
    void scroll(double steps) override
    {
        if (std::abs(steps) <= 1e308)
            distance_ =
                std::fmax(first_.min_distance, std::fmin(first_.max_distance, distance_ * std::pow(1 / 1.1, steps)));
    }
    void resize(int width, int height) override { pixels_ = width >= 1 && height >= 1 ? height : pixels_; }
    void reset() override
    {
        distance_ = first_.distance;
        turn_to(first_.yaw, first_.pitch);
    }
    glm::mat4 view() const override
    {
        glm::dmat4 result(transpose(axes_));
        result[3] = glm::dvec4(-(first_.target * axes_) - glm::dvec3(0, 0, distance_), 1);
        return glm::mat4(result);
    }

private:
    void turn_to(double yaw, double pitch)
    {
        yaw_ = yaw;
        pitch_ = std::fmax(-first_.max_pitch, std::fmin(first_.max_pitch, pitch));
        const glm::dquat about_y = glm::angleAxis(yaw_, glm::dvec3(0, 1, 0));
        const glm::dquat about_x = glm::angleAxis(-pitch_, glm::dvec3(1, 0, 0));
        axes_ = glm::mat3_cast(about_y * about_x);
    }

    OrbitCameraSettings first_;
    double pixels_;
    double yaw_ = 0;
    double pitch_ = 0;
    double distance_ = 0;
    glm::dmat3 axes_{1};  // columns: the camera's axes in world coordinates
};

}

std::unique_ptr<OrbitCamera> make_orbit_camera(const OrbitCameraSettings& settings)
{
    return std::make_unique<AxesCamera>(settings);
}

}
