// In extended precision. The control counts keys in whole numbers and multiplies once; only where the latitude stops it
// begins to count anew.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <umbral/lighting/light_direction.hpp>

namespace umbral::lighting {
namespace {

using Wide = long double;
using WideVector = glm::vec<3, Wide>;

constexpr Wide half_turn = std::numbers::pi_v<Wide>;

WideVector on_sky(const LightAngles& angles)
{
    const Wide alpha = std::fmod(Wide{angles.longitude_degrees}, 360.0L) / 180 * half_turn;
    const Wide beta = std::fmod(Wide{angles.latitude_degrees}, 360.0L) / 180 * half_turn;
    return {std::sin(alpha) * std::cos(beta), std::sin(beta), std::cos(alpha) * std::cos(beta)};
}

float within_a_turn(Wide degrees)
{
    const auto rounded = static_cast<float>(degrees - 360 * std::floor(degrees / 360));
    return rounded == 360 ? 0 : rounded;
}

class CountingControl final : public LightControl {
public:
    CountingControl(const LightAngles& initial, float step)
        : initial_(std::fmod(Wide{initial.longitude_degrees}, 360.0L)), step_(step), base_(initial.latitude_degrees)
    {
    }

    bool press(char key) override
    {
        const int lower = std::tolower(static_cast<unsigned char>(key));
        if (lower == 'x' || lower == 'c') {
            around_ += lower == 'x' ? 1 : -1;
            return true;
        }
        if (lower != 'a' && lower != 'z') return false;
        const Wide before = base_ + static_cast<Wide>(up_) * step_;
        up_ += lower == 'a' ? 1 : -1;
        const Wide after = base_ + static_cast<Wide>(up_) * step_;
        if (std::abs(after) >= 90) {
            base_ = after > 0 ? 90 : -90;
            up_ = 0;
            return before != base_;
        }
        return true;
    }

    [[nodiscard]] LightAngles angles() const override
    {
        return {within_a_turn(initial_ + static_cast<Wide>(around_) * step_),
                static_cast<float>(base_ + static_cast<Wide>(up_) * step_)};
    }

private:
    Wide initial_;
    Wide step_;
    Wide base_;
    std::int64_t around_ = 0;
    std::int64_t up_ = 0;
};

}

glm::vec3 light_direction(const LightAngles& angles) { return glm::vec3(on_sky(angles)); }

LightAngles light_angles(const glm::vec3& direction)
{
    const WideVector d(direction);
    if (d == WideVector(0)) return {};
    const Wide flat = std::sqrt(d.x * d.x + d.z * d.z);
    const Wide alpha = flat == 0 ? 0 : std::atan2(d.x, d.z);
    return {within_a_turn(alpha / half_turn * 180), static_cast<float>(std::atan2(d.y, flat) / half_turn * 180)};
}

glm::vec3 direction_in_camera(const LightAngles& angles, LightFrame frame, const glm::mat4& view)
{
    WideVector d = on_sky(angles);
    if (frame == LightFrame::world) d = glm::mat<3, 3, Wide>(glm::mat3(view)) * d;
    return glm::vec3(d);
}

glm::vec3 direction_in_world(const LightAngles& angles, LightFrame frame, const glm::mat4& view)
{
    WideVector d = on_sky(angles);
    if (frame == LightFrame::camera) d = d * glm::mat<3, 3, Wide>(glm::mat3(view));
    return glm::vec3(d);
}

std::unique_ptr<LightControl> make_light_control(const LightAngles& initial, float step_degrees)
{
    return std::make_unique<CountingControl>(initial, step_degrees);
}

}
