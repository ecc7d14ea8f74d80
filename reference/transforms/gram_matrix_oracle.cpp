#include <array>
#include <umbral/transforms/gram_matrix.hpp>

#include "wide.hpp"

// In __float128, through the world or by Lagrange's identity; rounded to float once.

namespace umbral::transforms {
namespace {

using Vector = std::array<Wide, 3>;

Vector widened(const glm::vec3& v) { return {v.x, v.y, v.z}; }

Wide dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector in_world(const glm::mat3& basis, const glm::vec3& a)
{
    Vector sum{};
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
    const Vector x = widened(basis[0]);
    const Vector y = widened(basis[1]);
    const Vector z = widened(basis[2]);
    const Vector product = cross(in_world(basis, a), in_world(basis, b));
    const Wide volume = dot(cross(x, y), z);
    return {static_cast<float>(dot(product, cross(y, z)) / volume),
            static_cast<float>(dot(product, cross(z, x)) / volume),
            static_cast<float>(dot(product, cross(x, y)) / volume)};
}

std::int64_t triple_product(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c)
{
    const auto wide = [](const glm::ivec3& v) { return Vector{Wide(v.x), Wide(v.y), Wide(v.z)}; };
    return static_cast<std::int64_t>(dot(cross(wide(a), wide(b)), wide(c)));
}

}
