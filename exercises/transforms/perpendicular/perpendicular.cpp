#include <umbral/transforms/perpendicular.hpp>

namespace umbral::transforms {

glm::vec2 turn_left(const glm::vec2& u)
{
    // TODO: (a, b) becomes (-b, a).
    return not_implemented<glm::vec2>(u);
}

glm::vec2 turn_right(const glm::vec2& u)
{
    // TODO: the inverse of turn_left.
    return not_implemented<glm::vec2>(u);
}

glm::vec2 turn_vector_in(const PlaneFrame& frame, const glm::vec2& u)
{
    // TODO: the coordinates of u in the frame are its dot products with frame.x and frame.y. Turn them, then go back to
    // the world.
    return not_implemented<glm::vec2>(frame, u);
}

glm::vec2 turn_point_in(const PlaneFrame& frame, const glm::vec2& point)
{
    // TODO: the vector from the frame's origin to the point turns; the origin stays.
    return not_implemented<glm::vec2>(frame, point);
}

glm::vec2 rotate_in_plane(const glm::vec2& u, float angle)
{
    // TODO: cosθ u + sinθ P(u).
    return not_implemented<glm::vec2>(u, angle);
}

glm::mat3 plane_rotation_matrix(float angle)
{
    // TODO: the columns are what becomes of (1, 0), of (0, 1) and of the origin.
    return not_implemented<glm::mat3>(angle);
}

glm::vec3 across(const glm::vec3& e, const glm::vec3& u)
{
    // TODO: e × u.
    return not_implemented<glm::vec3>(e, u);
}

glm::mat3 across_matrix(const glm::vec3& e)
{
    // TODO: the matrix whose product with u is e × u. Its columns are e × (1,0,0), e × (0,1,0), e × (0,0,1).
    return not_implemented<glm::mat3>(e);
}

}
