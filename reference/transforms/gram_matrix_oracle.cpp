#include <umbral/transforms/gram_matrix.hpp>

#include "wide_vector.hpp"

// In __float128, through the world or by Lagrange's identity; rounded to float once.

namespace umbral::transforms {
namespace {

WideVector in_world(const glm::mat3& basis, const glm::vec3& a)
{
    WideVector sum{};
    for (int row = 0; row < 3; ++row)
        for (int i = 0; i < 3; ++i) sum[static_cast<std::size_t>(row)] += Wide(basis[i][row]) * Wide(a[i]);
    return sum;
}

Wide expanded(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b)
{
    Wide sum = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum += Wide(a[i]) * Wide(b[j]) * Wide(gram[i][j]);
    return sum;
}

}

glm::mat3 gram_matrix(const glm::mat3& basis)
{
    glm::mat3 result;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result[i][j] = static_cast<float>(dot(widened(basis[i]), widened(basis[j])));
    return result;
}

float dot_from_gram(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b)
{
    return static_cast<float>(expanded(gram, a, b));
}

float area_from_gram(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b)
{
    const Wide mixed = expanded(gram, a, b);
    return static_cast<float>(square_root(expanded(gram, a, a) * expanded(gram, b, b) - mixed * mixed));
}

glm::vec3 cross_in_basis(const glm::mat3& basis, const glm::vec3& a, const glm::vec3& b)
{
    const WideVector x = widened(basis[0]);
    const WideVector y = widened(basis[1]);
    const WideVector z = widened(basis[2]);
    const WideVector product = cross(in_world(basis, a), in_world(basis, b));
    const Wide volume = dot(cross(x, y), z);
    return {static_cast<float>(dot(product, cross(y, z)) / volume),
            static_cast<float>(dot(product, cross(z, x)) / volume),
            static_cast<float>(dot(product, cross(x, y)) / volume)};
}

std::int64_t triple_product(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c)
{
    const auto wide = [](const glm::ivec3& v) { return WideVector{Wide(v.x), Wide(v.y), Wide(v.z)}; };
    return static_cast<std::int64_t>(dot(cross(wide(a), wide(b)), wide(c)));
}

}
