// Based on: the course's lab 4, light sources, with the sign of the latitude that its slides have: positive is up.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <umbral/lighting/light_direction.hpp>

namespace umbral::lighting {
namespace {

constexpr double degree = std::numbers::pi / 180;

// The remainder is exact, so that π comes in for less than a turn only.
glm::dvec3 direction_of(const LightAngles& angles)
{
    const double alpha = std::remainder(double{angles.longitude_degrees}, 360.0) * degree;
    const double beta = std::remainder(double{angles.latitude_degrees}, 360.0) * degree;
    return {std::cos(beta) * std::sin(alpha), std::sin(beta), std::cos(beta) * std::cos(alpha)};
}

// Of an angle in (-360, 360) that in [0, 360), also as a float: 360 less a hair rounds to 360.
float longitude(double degrees)
{
    const auto rounded = static_cast<float>(degrees < 0 ? degrees + 360 : degrees);
    return rounded < 360 ? rounded : 0;
}

class ReferenceControl final : public LightControl {
public:
    ReferenceControl(const LightAngles& initial, float step_degrees)
        : longitude_(std::remainder(double{initial.longitude_degrees}, 360.0)),
          latitude_(initial.latitude_degrees),
          step_(step_degrees)
    {
    }

    bool press(char key) override
    {
        switch (key) {
            case 'A':
            case 'a': return turn_up(step_);
            case 'Z':
            case 'z': return turn_up(-step_);
            case 'X':
            case 'x': longitude_ = std::remainder(longitude_ + step_, 360.0); return true;
            case 'C':
            case 'c': longitude_ = std::remainder(longitude_ - step_, 360.0); return true;
            default: return false;
        }
    }

    [[nodiscard]] LightAngles angles() const override { return {longitude(longitude_), static_cast<float>(latitude_)}; }

private:
    bool turn_up(double step)
    {
        const double before = latitude_;
        latitude_ = std::clamp(latitude_ + step, -90.0, 90.0);
        // Also a step that double does not hold is one.
        return step > 0 ? before < 90 : before > -90;
    }

    double longitude_;
    double latitude_;
    double step_;
};

}

glm::vec3 light_direction(const LightAngles& angles) { return glm::vec3(direction_of(angles)); }

LightAngles light_angles(const glm::vec3& direction)
{
    const glm::dvec3 d(direction);
    // Not by the arc sine of y / |d|: near the poles that knows half of the digits only.
    const double flat = std::hypot(d.x, d.z);
    if (flat == 0) return {0, d.y > 0 ? 90.0F : d.y < 0 ? -90.0F : 0.0F};
    return {longitude(std::atan2(d.x, d.z) / degree), static_cast<float>(std::atan2(d.y, flat) / degree)};
}

glm::vec3 direction_in_camera(const LightAngles& angles, LightFrame frame, const glm::mat4& view)
{
    const glm::dvec3 d = direction_of(angles);
    // A direction has w = 0: the translation does not move it.
    return glm::vec3(frame == LightFrame::camera ? d : glm::dmat3(view) * d);
}

glm::vec3 direction_in_world(const LightAngles& angles, LightFrame frame, const glm::mat4& view)
{
    const glm::dvec3 d = direction_of(angles);
    // A rotation's inverse is its transpose.
    return glm::vec3(frame == LightFrame::world ? d : glm::transpose(glm::dmat3(view)) * d);
}

std::unique_ptr<LightControl> make_light_control(const LightAngles& initial, float step_degrees)
{
    return std::make_unique<ReferenceControl>(initial, step_degrees);
}

}
