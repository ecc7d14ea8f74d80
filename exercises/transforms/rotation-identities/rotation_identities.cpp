#include <umbral/transforms/rotation_identities.hpp>

namespace umbral::transforms {

glm::vec3 elementary_rotation(const glm::vec3& vector, const ElementaryTurn& turn)
{
    // TODO: the coordinate of the axis stays; the two others turn as in the plane. Degrees, not radians.
    // For the exact turns: take off whole turns (std::remainder) and quarter turns before you go to radians.
    return not_implemented<glm::vec3>(vector, turn);
}

glm::mat3 elementary_matrix(const ElementaryTurn& turn)
{
    // TODO: the columns are what becomes of (1,0,0), (0,1,0) and (0,0,1).
    return not_implemented<glm::mat3>(turn);
}

glm::vec3 after_turns(const glm::vec3& vector, std::span<const ElementaryTurn> turns)
{
    // TODO: one turn after the other. There may be a million: do not round to float in between.
    return not_implemented<glm::vec3>(vector, turns);
}

}
