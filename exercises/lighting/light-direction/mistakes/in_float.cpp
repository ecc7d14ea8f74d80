// mistake: keeps and computes everything in float
// credit: 88..98
// hint: After many turns your angles have lost their digits: a large angle in radians has few of them in float, and a
// sum of a thousand steps rounds a thousand times. Take whole turns off first, and keep the angles in double.
#include <cmath>
#include <umbral/lighting/light_direction.hpp>

namespace umbral::lighting {
namespace {

class Control : public LightControl {
public:
    Control(const LightAngles& initial, float step) : now_(initial), step_(step) {}

    bool press(char key) override
    {
        const float before = now_.latitude_degrees;
        switch (std::toupper(key)) {
            case 'A': now_.latitude_degrees = std::min(before + step_, 90.0F); return now_.latitude_degrees != before;
            case 'Z': now_.latitude_degrees = std::max(before - step_, -90.0F); return now_.latitude_degrees != before;
            case 'X': now_.longitude_degrees += step_; return true;
            case 'C': now_.longitude_degrees -= step_; return true;
            default: return false;
        }
    }

    LightAngles angles() const override
    {
        const float turned = std::fmod(now_.longitude_degrees, 360.0F);
        return {turned < 0 ? turned + 360 : turned, now_.latitude_degrees};
    }

private:
    LightAngles now_;
    float step_;
};

}

glm::vec3 light_direction(const LightAngles& angles)
{
    const float alpha = glm::radians(angles.longitude_degrees);
    const float beta = glm::radians(angles.latitude_degrees);
    return {std::cos(beta) * std::sin(alpha), std::sin(beta), std::cos(beta) * std::cos(alpha)};
}

LightAngles light_angles(const glm::vec3& direction)
{
    const float flat = std::hypot(direction.x, direction.z);
    const float longitude = flat == 0 ? 0 : glm::degrees(std::atan2(direction.x, direction.z));
    const float turned = longitude < 0 ? longitude + 360 : longitude;
    return {turned == 360 ? 0 : turned, glm::degrees(std::atan2(direction.y, flat))};
}

glm::vec3 direction_in_camera(const LightAngles& angles, LightFrame frame, const glm::mat4& view)
{
    const glm::vec3 d = light_direction(angles);
    return frame == LightFrame::camera ? d : glm::mat3(view) * d;
}

glm::vec3 direction_in_world(const LightAngles& angles, LightFrame frame, const glm::mat4& view)
{
    const glm::vec3 d = light_direction(angles);
    return frame == LightFrame::world ? d : d * glm::mat3(view);
}

std::unique_ptr<LightControl> make_light_control(const LightAngles& initial, float step_degrees)
{
    return std::make_unique<Control>(initial, step_degrees);
}

}
