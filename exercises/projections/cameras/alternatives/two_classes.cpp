// alternative: two classes that make their matrices at each activation, by the units before this one and products
#include <cmath>
#include <stdexcept>
#include <umbral/projections/camera.hpp>
#include <umbral/projections/orthographic.hpp>
#include <umbral/projections/perspective.hpp>

namespace umbral::projections {
namespace {

struct Window {
    int width = 1;
    int height = 1;

    void resize(int new_width, int new_height)
    {
        if (new_width < 1 || new_height < 1) return;
        width = new_width;
        height = new_height;
    }
    [[nodiscard]] float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
};

class Box : public Camera {
public:
    void set_viewport(int width, int height) override { window_.resize(width, height); }
    void activate(MatrixTarget& target) override
    {
        const float half = 1 / window_.aspect();
        target.set_projection(orthographic_matrix({-1, 1, -half, half, -1, 1}));
        target.set_view(glm::mat4(1));
    }

private:
    Window window_;
};

class Orbit : public OrbitalCamera {
public:
    Orbit(float a_degrees, float b_degrees, float distance)
        : a_(finite(a_degrees)), b_(finite(b_degrees)), distance_(positive(distance))
    {
    }

    void set_viewport(int width, int height) override { window_.resize(width, height); }
    void set_angles(float a_degrees, float b_degrees) override
    {
        const float b = finite(b_degrees);
        a_ = finite(a_degrees);
        b_ = b;
    }
    void set_distance(float distance) override { distance_ = positive(distance); }
    void activate(MatrixTarget& target) override
    {
        const glm::dmat4 moved = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -distance_));
        const glm::dmat4 raised = glm::rotate(moved, turn(b_), glm::dvec3(1, 0, 0));
        target.set_view(glm::mat4(glm::rotate(raised, -turn(a_), glm::dvec3(0, 1, 0))));
        target.set_projection(perspective_matrix({60, window_.aspect(), 0.05F, 1000.05F}));
    }

private:
    /// In radians, without whole turns: in degrees they come off exactly.
    static double turn(float degrees) { return glm::radians(std::remainder(double{degrees}, 360.0)); }
    static float finite(float number)
    {
        if (!std::isfinite(number)) throw std::invalid_argument("angle");
        return number;
    }
    static float positive(float number)
    {
        if (!std::isfinite(number) || number <= 0) throw std::invalid_argument("distance");
        return number;
    }

    Window window_;
    float a_;
    float b_;
    float distance_;
};

}

std::unique_ptr<Camera> make_camera() { return std::make_unique<Box>(); }

std::unique_ptr<OrbitalCamera> make_orbital_camera(float a_degrees, float b_degrees, float distance)
{
    return std::make_unique<Orbit>(a_degrees, b_degrees, distance);
}

}
