#include <umbral/transforms/about_a_point.hpp>

namespace umbral::transforms {

glm::mat4 rotation_about_point(const glm::vec3& centre, const AxisAngle& turn)
{
    // TODO: Tra[centre] · Rot · Tra[-centre]. rotation_matrix(turn) is there for you.
    return not_implemented<glm::mat4>(centre, turn);
}

glm::mat4 scaling_about_point(const glm::vec3& centre, const glm::vec3& factors)
{
    // TODO: Tra[centre] · Esc · Tra[-centre].
    return not_implemented<glm::mat4>(centre, factors);
}

glm::mat4 scaling_along(const glm::vec3& point, const glm::vec3& direction, float factor)
{
    // TODO: with e the unit vector, I + (factor - 1) e eᵀ about `point`. The identity for a null direction.
    return not_implemented<glm::mat4>(point, direction, factor);
}

glm::mat4 reflection_in_point(const glm::vec3& centre)
{
    // TODO: p becomes 2 centre - p.
    return not_implemented<glm::mat4>(centre);
}

glm::mat4 reflection_in_line(const glm::vec3& point, const glm::vec3& direction)
{
    // TODO: with e the unit vector along the line, 2 e eᵀ - I about `point`. The identity for a null direction.
    return not_implemented<glm::mat4>(point, direction);
}

glm::mat4 reflection_in_plane(const glm::vec3& point, const glm::vec3& normal)
{
    // TODO: with n the unit normal, I - 2 n nᵀ about `point`. The identity for a null normal.
    return not_implemented<glm::mat4>(point, normal);
}

glm::mat4 alignment(const glm::vec3& from, const glm::vec3& to)
{
    // TODO: a turn about from × to. Think of parallel, opposite and null vectors before you divide.
    return not_implemented<glm::mat4>(from, to);
}

glm::mat4 placed_along(const glm::vec3& position, const glm::vec3& direction)
{
    // TODO: the columns are unit(Y × direction), z × x, unit(direction) and the position. Where does Y × direction
    // vanish?
    return not_implemented<glm::mat4>(position, direction);
}

}
