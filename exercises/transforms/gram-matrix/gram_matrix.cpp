#include <umbral/transforms/gram_matrix.hpp>

namespace umbral::transforms {

glm::mat3 gram_matrix(const glm::mat3& basis)
{
    // TODO: entry [i][j] is the dot product of the columns basis[i] and basis[j].
    return not_implemented<glm::mat3>(basis);
}

float dot_from_gram(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b)
{
    // TODO: multiply (a0 e0 + a1 e1 + a2 e2) · (b0 e0 + b1 e1 + b2 e2) out: nine terms.
    return not_implemented<float>(gram, a, b);
}

float area_from_gram(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b)
{
    // TODO: the square of the area is |a|²|b|² - (a·b)². Mind vectors that are nearly parallel.
    return not_implemented<float>(gram, a, b);
}

glm::vec3 cross_in_basis(const glm::mat3& basis, const glm::vec3& a, const glm::vec3& b)
{
    // TODO: to the world, the cross product there, and back to coordinates.
    return not_implemented<glm::vec3>(basis, a, b);
}

std::int64_t triple_product(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c)
{
    // TODO: the cross product of a and b, times c. Mind numbers that do not fit into 32 bits.
    return not_implemented<std::int64_t>(a, b, c);
}

}
