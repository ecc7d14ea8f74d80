// mistake: everything in float, the area by Lagrange's identity
// credit: 72..90
// hint: In float, |a|²|b|² and (a·b)² agree in all digits when the vectors are nearly parallel, and their squares are
// no floats when the units are small or large. Compute in double, and do not subtract squares.
#include <cmath>
#include <umbral/transforms/gram_matrix.hpp>

namespace umbral::transforms {

glm::mat3 gram_matrix(const glm::mat3& basis) { return glm::transpose(basis) * basis; }

float dot_from_gram(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b) { return glm::dot(a, gram * b); }

float area_from_gram(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b)
{
    const float mixed = dot_from_gram(gram, a, b);
    return std::sqrt(std::max(0.0F, dot_from_gram(gram, a, a) * dot_from_gram(gram, b, b) - mixed * mixed));
}

glm::vec3 cross_in_basis(const glm::mat3& basis, const glm::vec3& a, const glm::vec3& b)
{
    return glm::inverse(basis) * glm::cross(basis * a, basis * b);
}

std::int64_t triple_product(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c)
{
    const auto minor = [&](int i, int j) { return std::int64_t{a[i]} * b[j] - std::int64_t{a[j]} * b[i]; };
    return minor(1, 2) * c.x + minor(2, 0) * c.y + minor(0, 1) * c.z;
}

}
