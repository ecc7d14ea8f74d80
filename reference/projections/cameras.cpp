// Based on: the course's classes Camara and CamaraOrbitalSimple,
// V = Tra(0, 0, -d) · Rot(b, X) · Rot(-a, Y).

#include <umbral/projections/camera.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace umbral::projections {
namespace {

/// What all cameras do alike: matrices are made when they are needed, and only if something has changed since.
template <class Interface>
class CameraWithMatrices : public Interface {
public:
    void set_viewport(int width, int height) final
    {
        if (width <= 0 || height <= 0) return;
        aspect_ = static_cast<double>(width) / height;
        changed_ = true;
    }

    void activate(MatrixTarget& target) final
    {
        if (changed_) {
            view_ = glm::mat4(view());
            projection_ = glm::mat4(projection(aspect_));
            changed_ = false;
        }
        target.set_view(view_);
        target.set_projection(projection_);
    }

protected:
    [[nodiscard]] virtual glm::dmat4 view() const = 0;
    /// `aspect` is width over height.
    [[nodiscard]] virtual glm::dmat4 projection(double aspect) const = 0;

    void set_changed() { changed_ = true; }

private:
    double aspect_ = 1;
    bool changed_ = true;
    glm::mat4 view_{1};
    glm::mat4 projection_{1};
};

/// A box of 2 x 2 h/w x 2 becomes the cube. z changes its sign: depth grows away from the viewer.
class BaseCamera final : public CameraWithMatrices<Camera> {
    [[nodiscard]] glm::dmat4 view() const override { return glm::dmat4(1); }
    [[nodiscard]] glm::dmat4 projection(double aspect) const override
    {
        glm::dmat4 scaling(1);
        scaling[1][1] = aspect;
        scaling[2][2] = -1;
        return scaling;
    }
};

class ReferenceOrbitalCamera final : public CameraWithMatrices<OrbitalCamera> {
public:
    void set_angles(float a_degrees, float b_degrees) override
    {
        if (!std::isfinite(a_degrees) || !std::isfinite(b_degrees))
            throw std::invalid_argument("a camera's angles must be finite");
        a_ = radians(a_degrees);
        b_ = radians(b_degrees);
        set_changed();
    }

    void set_distance(float distance) override
    {
        if (!(distance > 0) || std::isinf(distance))
            throw std::invalid_argument("a camera's distance must be more than 0, and finite");
        distance_ = distance;
        set_changed();
    }

private:
    /// Whole turns are taken off first, exactly.
    static double radians(float degrees) { return std::remainder(degrees, 360.0) * std::numbers::pi / 180; }

    /// The rows are the camera's axes, the product of the two rotations.
    [[nodiscard]] glm::dmat4 view() const override
    {
        const double sa = std::sin(a_);
        const double ca = std::cos(a_);
        const double sb = std::sin(b_);
        const double cb = std::cos(b_);
        return {{ca, sb * -sa, cb * sa, 0},  //
                {0, cb, sb, 0},
                {-sa, sb * -ca, cb * ca, 0},
                {0, 0, -distance_, 1}};
    }

    [[nodiscard]] glm::dmat4 projection(double aspect) const override
    {
        constexpr double near_plane = 0.05;
        constexpr double far_plane = near_plane + 1000;
        const double cotangent = std::numbers::sqrt3;  // of half of 60 degrees
        return {{cotangent / aspect, 0, 0, 0},
                {0, cotangent, 0, 0},
                {0, 0, (near_plane + far_plane) / (near_plane - far_plane), -1},
                {0, 0, 2 * near_plane * far_plane / (near_plane - far_plane), 0}};
    }

    double a_ = 0;
    double b_ = 0;
    double distance_ = 1;
};

}

std::unique_ptr<Camera> make_camera() { return std::make_unique<BaseCamera>(); }

std::unique_ptr<OrbitalCamera> make_orbital_camera(float a_degrees, float b_degrees, float distance)
{
    auto camera = std::make_unique<ReferenceOrbitalCamera>();
    camera->set_angles(a_degrees, b_degrees);
    camera->set_distance(distance);
    return camera;
}

}
