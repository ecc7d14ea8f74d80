// alternative: a triangular basis with the same products, by Cholesky's method; cross products by the world
#include <cmath>
#include <umbral/transforms/gram_matrix.hpp>

namespace umbral::transforms {
namespace {

/// An upper triangular matrix whose columns have these dot products.
glm::dmat3 triangular_basis(const glm::dmat3& gram)
{
    glm::dmat3 e(0);
    for (int i = 0; i < 3; ++i) {
        double rest = gram[i][i];
        for (int j = 0; j < i; ++j) {
            double mixed = gram[i][j];
            for (int k = 0; k < j; ++k) mixed -= e[i][k] * e[j][k];
            e[i][j] = mixed / e[j][j];
            rest -= e[i][j] * e[i][j];
        }
        e[i][i] = std::sqrt(rest);
    }
    return e;
}

}

glm::mat3 gram_matrix(const glm::mat3& basis)
{
    glm::mat3 result;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            result[i][j] = static_cast<float>(glm::dot(glm::dvec3(basis[i]), glm::dvec3(basis[j])));
    return result;
}

float dot_from_gram(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b)
{
    double sum = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum += double{a[i]} * double{b[j]} * double{gram[i][j]};
    return static_cast<float>(sum);
}

float area_from_gram(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b)
{
    const glm::dmat3 e = triangular_basis(glm::dmat3(gram));
    return static_cast<float>(glm::length(glm::cross(e * glm::dvec3(a), e * glm::dvec3(b))));
}

glm::vec3 cross_in_basis(const glm::mat3& basis, const glm::vec3& a, const glm::vec3& b)
{
    const glm::dmat3 e(basis);
    return glm::vec3(glm::inverse(e) * glm::cross(e * glm::dvec3(a), e * glm::dvec3(b)));
}

std::int64_t triple_product(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c)
{
    const auto product = [](int x, int y, int z) { return std::int64_t{x} * y * z; };
    return product(a.x, b.y, c.z) + product(b.x, c.y, a.z) + product(c.x, a.y, b.z) - product(c.x, b.y, a.z) -
           product(a.x, c.y, b.z) - product(b.x, a.y, c.z);
}

}
