// alternative: a small class for each mode, changed like gears; the matrix is the product Tra(0,0,-r) Rot(b,X)
// Rot(-a,Y) Tra(-attention), and axes are read from it
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/interaction/three_mode_camera.hpp>

namespace umbral::interaction {
namespace {

struct State {
    ThreeModeSettings s;

    glm::dmat4 matrix() const
    {
        glm::dmat4 v = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -s.distance));
        v = glm::rotate(v, s.elevation, glm::dvec3(1, 0, 0));
        v = glm::rotate(v, -s.azimuth, glm::dvec3(0, 1, 0));
        return glm::translate(v, -s.attention);
    }
    glm::dvec3 axis(int row) const
    {
        const glm::dmat4 v = matrix();
        return {v[0][row], v[1][row], v[2][row]};
    }
    glm::dvec3 eye() const { return s.attention + s.distance * axis(2); }
    void rotate(double right, double up)
    {
        const double quarter = 2 * std::atan(1.0);
        s.azimuth = std::fmod(s.azimuth + right, 4 * quarter);
        s.elevation = std::max(-quarter, std::min(quarter, s.elevation + up));
    }
    void set_distance(double r)
    {
        const double low = s.min_distance * 1.001;
        s.distance = r > s.max_distance ? s.max_distance : r < low ? low : r;
    }
};

struct Gear {
    virtual ~Gear() = default;
    virtual void xy(State& state, double right, double up) const = 0;
    virtual void z(State& state, double steps) const { state.s.attention += steps * state.axis(2); }
};
struct Examine : Gear {
    void xy(State& state, double right, double up) const override { state.rotate(right, up); }
    void z(State& state, double steps) const override
    {
        const double least = state.s.min_distance;
        state.set_distance(least + (state.s.distance - least) * std::pow(1 + state.s.zoom_step, steps));
    }
};
struct Walk : Gear {
    void xy(State& state, double right, double up) const override
    {
        state.s.attention += right * state.axis(0) + up * state.axis(1);
    }
};
struct LookAround : Gear {
    void xy(State& state, double right, double up) const override
    {
        const glm::dvec3 fixed = state.eye();
        state.rotate(right, up);
        state.s.attention += fixed - state.eye();
    }
};

class GearedCamera : public ThreeModeCamera {
public:
    explicit GearedCamera(const ThreeModeSettings& settings) : state_{settings} {}
    void move_xy(double right, double up) override
    {
        if (std::isfinite(right) && std::isfinite(up)) gear().xy(state_, right, up);
    }
    void move_z(double steps) override
    {
        if (std::isfinite(steps)) gear().z(state_, steps);
    }
    void look_toward(const glm::dvec3& point) override
    {
        const glm::dvec3 eye = state_.eye();
        const glm::dvec3 way = point - eye;
        const double r = std::hypot(way.x, way.y, way.z);
        if (!(r >= 1e-6) || std::isinf(r)) return;
        const double flat = std::hypot(way.x, way.z);
        if (flat / r >= 1e-6) state_.s.azimuth = std::atan2(-way.x, -way.z);
        state_.s.elevation = std::asin(-way.y / r);
        if (std::abs(way.y) > 0.9 * r) state_.s.elevation = std::copysign(std::acos(flat / r), -way.y);
        state_.set_distance(r);
        state_.s.attention = eye - state_.s.distance * state_.axis(2);
        state_.s.mode = CameraMode::examine;
    }
    void next_mode() override { state_.s.mode = static_cast<CameraMode>((static_cast<int>(state_.s.mode) + 1) % 3); }
    CameraMode mode() const override { return state_.s.mode; }
    glm::dvec3 attention_point() const override { return state_.s.attention; }
    glm::mat4 view() const override { return glm::mat4(state_.matrix()); }

private:
    const Gear& gear() const
    {
        const std::array<const Gear*, 3> gears{&examine_, &walk_, &look_around_};
        return *gears[static_cast<std::size_t>(state_.s.mode)];
    }

    State state_;
    Examine examine_;
    Walk walk_;
    LookAround look_around_;
};

}

std::unique_ptr<ThreeModeCamera> make_three_mode_camera(const ThreeModeSettings& settings)
{
    return std::make_unique<GearedCamera>(settings);
}

}
