// alternative: turns +z by two rotation matrices, first about -x and then about y; keys from a table; in double
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/lighting/light_direction.hpp>

namespace umbral::lighting {
namespace {

glm::dmat3 sky(const LightAngles& angles)
{
    const double alpha = glm::radians(std::fmod(double(angles.longitude_degrees), 360.0));
    const double beta = glm::radians(std::fmod(double(angles.latitude_degrees), 360.0));
    const glm::dmat4 about_y = glm::rotate(glm::dmat4(1), alpha, glm::dvec3(0, 1, 0));
    return glm::dmat3(glm::rotate(about_y, beta, glm::dvec3(-1, 0, 0)));
}

class Control : public LightControl {
public:
    Control(LightAngles start, float step) : alpha_(start.longitude_degrees), beta_(start.latitude_degrees), step_(step)
    {
        wrap();
    }

    bool press(char key) override
    {
        struct Row {
            char small, large;
            int around, up;
        };
        constexpr std::array<Row, 4> rows = {
            {{'a', 'A', 0, 1}, {'z', 'Z', 0, -1}, {'x', 'X', 1, 0}, {'c', 'C', -1, 0}}};
        for (const Row& row : rows) {
            if (key != row.small && key != row.large) continue;
            const double old_alpha = alpha_;
            const double old_beta = beta_;
            alpha_ += row.around * step_;
            beta_ = glm::clamp(beta_ + row.up * step_, -90.0, 90.0);
            wrap();
            return alpha_ != old_alpha || beta_ != old_beta;
        }
        return false;
    }

    LightAngles angles() const override
    {
        const float alpha = static_cast<float>(alpha_);
        return {alpha >= 360 ? 0 : alpha, static_cast<float>(beta_)};
    }

private:
    void wrap()
    {
        alpha_ = std::fmod(alpha_, 360.0);
        if (alpha_ < 0) alpha_ += 360;
    }

    double alpha_, beta_, step_;
};

}

glm::vec3 light_direction(const LightAngles& angles) { return glm::vec3(sky(angles)[2]); }

LightAngles light_angles(const glm::vec3& direction)
{
    const glm::dvec3 d(direction);
    double alpha = d.x == 0 && d.z == 0 ? 0.0 : glm::degrees(std::atan2(d.x, d.z));
    const double beta = glm::degrees(std::atan2(d.y, std::sqrt(d.x * d.x + d.z * d.z)));
    if (alpha < 0) alpha += 360;
    const float result = static_cast<float>(alpha);
    return {result == 360.0F ? 0.0F : result, static_cast<float>(beta)};
}

glm::vec3 direction_in_camera(const LightAngles& angles, LightFrame frame, const glm::mat4& view)
{
    const glm::dvec4 d(sky(angles)[2], 0);
    return glm::vec3(frame == LightFrame::world ? glm::dmat4(view) * d : d);
}

glm::vec3 direction_in_world(const LightAngles& angles, LightFrame frame, const glm::mat4& view)
{
    const glm::dvec4 d(sky(angles)[2], 0);
    return glm::vec3(frame == LightFrame::camera ? glm::inverse(glm::dmat4(view)) * d : d);
}

std::unique_ptr<LightControl> make_light_control(const LightAngles& initial, float step_degrees)
{
    return std::make_unique<Control>(initial, step_degrees);
}

}
