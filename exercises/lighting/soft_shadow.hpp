#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

/// Shadows of balls, for pictures only: the illumination model knows none.
namespace umbral::lighting {

struct Ball {
    glm::vec3 centre{0};
    float radius = 1;
};

/// How much of a lamp of some radius is seen from a place past a ball, 0 to 1: the angle between the two against their
/// radii.
inline float share_seen(const glm::vec3& place, const glm::vec3& lamp, float lamp_radius, const Ball& ball)
{
    const glm::vec3 to_ball = ball.centre - place;
    const glm::vec3 to_lamp = lamp - place;
    const float towards = dot(to_ball, to_lamp);
    // Most balls are behind, or so far aside that no angle need be computed.
    if (towards <= 0) return 1;
    const float along = towards / dot(to_lamp, to_lamp);
    const glm::vec3 aside = to_ball - along * to_lamp;
    const float reach = ball.radius + along * lamp_radius;
    if (dot(aside, aside) > 1.3F * reach * reach) return 1;
    const float cosine = towards / (length(to_ball) * length(to_lamp));
    const float hidden = std::asin(std::min(1.0F, ball.radius / length(to_ball)));
    const float soft = lamp_radius / length(to_lamp);
    return glm::smoothstep(hidden - soft, hidden + soft, std::acos(std::min(1.0F, cosine)));
}

}
