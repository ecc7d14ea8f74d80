// alternative: the course's product Tra(0,0,-d) Rot(b,X) Rot(-a,Y) Tra(-target), each factor by GLM in double; degrees
// within one turn
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/interaction/orbit_camera.hpp>

namespace umbral::interaction {
namespace {

class ProductCamera : public OrbitCamera {
public:
    explicit ProductCamera(const OrbitCameraSettings& settings) : settings_(settings), height_(settings.viewport_height)
    {
        reset();
    }

    void drag(double right, double up) override
    {
        if (std::isnan(right) || std::isnan(up) || std::isinf(right) || std::isinf(up)) return;
        a_ = std::fmod(a_ - 180 * right / height_, 360);
        const double limit = glm::degrees(settings_.max_pitch);
        b_ = std::min(std::max(b_ - 180 * up / height_, -limit), limit);
    }
    void scroll(double steps) override
    {
        if (std::isnan(steps) || std::isinf(steps)) return;
        d_ = std::min(std::max(d_ * std::exp(-steps * std::log(1.1)), settings_.min_distance), settings_.max_distance);
    }
    void resize(int width, int height) override
    {
        if (width <= 0 || height <= 0) return;
        height_ = height;
    }
    void reset() override
    {
        a_ = glm::degrees(settings_.yaw);
        b_ = glm::degrees(settings_.pitch);
        d_ = settings_.distance;
    }
    glm::mat4 view() const override
    {
        glm::dmat4 v = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -d_));
        v = glm::rotate(v, glm::radians(b_), glm::dvec3(1, 0, 0));
        v = glm::rotate(v, glm::radians(-a_), glm::dvec3(0, 1, 0));
        return glm::mat4(glm::translate(v, -settings_.target));
    }

private:
    OrbitCameraSettings settings_;
    int height_;
    double a_ = 0;
    double b_ = 0;
    double d_ = 0;
};

}

std::unique_ptr<OrbitCamera> make_orbit_camera(const OrbitCameraSettings& settings)
{
    return std::make_unique<ProductCamera>(settings);
}

}
