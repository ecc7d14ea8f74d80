// Based on: C. Ureña. Informática Gráfica, tema 2, "rotaciones de 90° a izquierdas en 2D", "rotaciones arbitrarias en
// 2D". 2021.

#include <cmath>
#include <umbral/transforms/perpendicular.hpp>

namespace umbral::transforms {

glm::vec2 turn_left(const glm::vec2& u) { return {-u.y, u.x}; }

glm::vec2 turn_right(const glm::vec2& u) { return {u.y, -u.x}; }

glm::vec2 turn_vector_in(const PlaneFrame& frame, const glm::vec2& u)
{
    const float a = dot(u, frame.x);
    const float b = dot(u, frame.y);
    return -b * frame.x + a * frame.y;
}

glm::vec2 turn_point_in(const PlaneFrame& frame, const glm::vec2& point)
{
    return frame.origin + turn_vector_in(frame, point - frame.origin);
}

glm::vec2 rotate_in_plane(const glm::vec2& u, float angle)
{
    return std::cos(angle) * u + std::sin(angle) * turn_left(u);
}

glm::mat3 plane_rotation_matrix(float angle)
{
    return {glm::vec3(rotate_in_plane({1, 0}, angle), 0), glm::vec3(rotate_in_plane({0, 1}, angle), 0),
            glm::vec3(0, 0, 1)};
}

glm::vec3 across(const glm::vec3& e, const glm::vec3& u) { return cross(e, u); }

glm::mat3 across_matrix(const glm::vec3& e) { return {cross(e, {1, 0, 0}), cross(e, {0, 1, 0}), cross(e, {0, 0, 1})}; }

}
