#include <umbral/projections/camera.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

// With at least 64 bits: products of elementary matrices, rounded to float once. Nothing is kept between activations.

namespace umbral::projections {
namespace {

using Wide = long double;
using WideMatrix = glm::mat<4, 4, Wide>;

constexpr Wide degree = std::numbers::pi_v<Wide> / 180;

/// The rotation about the x axis (0) or the y axis (1).
WideMatrix rotation(int axis, float degrees)
{
    const Wide angle = std::remainder(Wide{degrees}, Wide{360}) * degree;
    const int from = axis == 0 ? 1 : 2;
    const int to = axis == 0 ? 2 : 0;
    WideMatrix matrix(1);
    matrix[from][from] = matrix[to][to] = std::cos(angle);
    matrix[from][to] = std::sin(angle);
    matrix[to][from] = -std::sin(angle);
    return matrix;
}

class Box final : public Camera {
public:
    void set_viewport(int width, int height) override
    {
        if (width > 0 && height > 0) size_ = {width, height};
    }
    void activate(MatrixTarget& target) override
    {
        target.set_view(glm::mat4(1));
        glm::mat4 projection(1);
        projection[1][1] = static_cast<float>(Wide(size_.x) / size_.y);
        projection[2][2] = -1;
        target.set_projection(projection);
    }

private:
    glm::ivec2 size_{1, 1};
};

class Orbit final : public OrbitalCamera {
public:
    void set_viewport(int width, int height) override
    {
        if (width > 0 && height > 0) size_ = {width, height};
    }
    void set_angles(float a_degrees, float b_degrees) override
    {
        if (!std::isfinite(a_degrees) || !std::isfinite(b_degrees)) throw std::invalid_argument("angles");
        a_ = a_degrees;
        b_ = b_degrees;
    }
    void set_distance(float distance) override
    {
        if (!std::isfinite(distance) || distance <= 0) throw std::invalid_argument("distance");
        distance_ = distance;
    }
    void activate(MatrixTarget& target) override
    {
        WideMatrix translation(1);
        translation[3][2] = -distance_;
        target.set_view(glm::mat4(translation * rotation(0, b_) * rotation(1, -a_)));
        const Wide near_plane = 0.05L;
        const Wide far_plane = 1000.05L;
        const Wide cotangent = 1 / std::tan(30 * degree);
        glm::mat4 projection(0);
        projection[0][0] = static_cast<float>(cotangent * size_.y / size_.x);
        projection[1][1] = static_cast<float>(cotangent);
        projection[2][2] = static_cast<float>(-(far_plane + near_plane) / (far_plane - near_plane));
        projection[3][2] = static_cast<float>(-2 * far_plane * near_plane / (far_plane - near_plane));
        projection[2][3] = -1;
        target.set_projection(projection);
    }

private:
    glm::ivec2 size_{1, 1};
    float a_ = 0;
    float b_ = 0;
    float distance_ = 1;
};

}

std::unique_ptr<Camera> make_camera() { return std::make_unique<Box>(); }

std::unique_ptr<OrbitalCamera> make_orbital_camera(float a_degrees, float b_degrees, float distance)
{
    auto camera = std::make_unique<Orbit>();
    camera->set_angles(a_degrees, b_degrees);
    camera->set_distance(distance);
    return camera;
}

}
