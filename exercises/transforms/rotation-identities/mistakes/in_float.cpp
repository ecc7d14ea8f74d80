// mistake: radians, sines and chains in float
// credit: 52..78
// hint: Your quarter turns leave a rest of 1e-8 where there should be 0, and long chains drift: lengths, dot and cross
// products are not kept. Take off whole and quarter turns in degrees, where that is exact, and go on in double.
#include <cmath>
#include <umbral/transforms/rotation_identities.hpp>

namespace umbral::transforms {

glm::vec3 elementary_rotation(const glm::vec3& v, const ElementaryTurn& turn)
{
    const float c = std::cos(glm::radians(turn.degrees));
    const float s = std::sin(glm::radians(turn.degrees));
    if (turn.axis == WorldAxis::x) return {v.x, c * v.y - s * v.z, s * v.y + c * v.z};
    if (turn.axis == WorldAxis::y) return {s * v.z + c * v.x, v.y, c * v.z - s * v.x};
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

glm::mat3 elementary_matrix(const ElementaryTurn& turn)
{
    return {elementary_rotation({1, 0, 0}, turn), elementary_rotation({0, 1, 0}, turn),
            elementary_rotation({0, 0, 1}, turn)};
}

glm::vec3 after_turns(const glm::vec3& vector, std::span<const ElementaryTurn> turns)
{
    glm::vec3 v = vector;
    for (const ElementaryTurn& turn : turns) v = elementary_rotation(v, turn);
    return v;
}

}
