#include <umbral/lighting/light_direction.hpp>

namespace umbral::lighting {

glm::vec3 light_direction(const LightAngles& angles)
{
    // TODO: (cos β sin α, sin β, cos β cos α), the angles in radians.
    return not_implemented<glm::vec3>(angles);
}

LightAngles light_angles(const glm::vec3& direction)
{
    // TODO: both angles by atan2; the longitude of 0 to 360.
    return not_implemented<LightAngles>(direction);
}

glm::vec3 direction_in_camera(const LightAngles& angles, LightFrame frame, const glm::mat4& view)
{
    // TODO: the direction in its own frame, and from the world's to the camera's if that is another one.
    return not_implemented<glm::vec3>(angles, frame, view);
}

glm::vec3 direction_in_world(const LightAngles& angles, LightFrame frame, const glm::mat4& view)
{
    // TODO: likewise, the other way round.
    return not_implemented<glm::vec3>(angles, frame, view);
}

std::unique_ptr<LightControl> make_light_control(const LightAngles& initial, float step_degrees)
{
    // TODO: a class of your own, derived from LightControl, that keeps the angles and the step.
    return not_implemented<std::unique_ptr<LightControl>>(initial, step_degrees);
}

}
