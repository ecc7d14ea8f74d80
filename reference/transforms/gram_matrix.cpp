// Based on: C. Ureña. Informática Gráfica, tema 1, problems 1.8 to 1.10. 2021; the Gram matrix's cofactors as the
// metric of areas: J. A. Schouten. Tensor Analysis for Physicists. 1951.

#include <cmath>
#include <umbral/transforms/gram_matrix.hpp>

namespace umbral::transforms {
namespace {

/// The usual formula, on coordinates in whatever basis: in double, the products of floats are exact.
glm::dvec3 crossed(const glm::dvec3& a, const glm::dvec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

glm::dmat3 wide_gram(const glm::dmat3& basis) { return glm::transpose(basis) * basis; }

/// Of a symmetric matrix: its inverse times its determinant.
glm::dmat3 cofactors(const glm::dmat3& m) { return {crossed(m[1], m[2]), crossed(m[2], m[0]), crossed(m[0], m[1])}; }

}

glm::mat3 gram_matrix(const glm::mat3& basis) { return glm::mat3(wide_gram(glm::dmat3(basis))); }

float dot_from_gram(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b)
{
    return static_cast<float>(dot(glm::dvec3(a), glm::dmat3(gram) * glm::dvec3(b)));
}

// |a|²|b|² - (a·b)² would subtract two nearly equal numbers where the angle is small. Written out it is the sum over
// the minors of (a, b), weighted with the cofactors (Cauchy and Binet): nothing is left to cancel but in the minors,
// which are exact to a rounding.
float area_from_gram(const glm::mat3& gram, const glm::vec3& a, const glm::vec3& b)
{
    const glm::dvec3 minors = crossed(glm::dvec3(a), glm::dvec3(b));
    return static_cast<float>(std::sqrt(dot(minors, cofactors(glm::dmat3(gram)) * minors)));
}

// The minors are the coordinates of the cross product in the basis of e1 × e2, e2 × e0, e0 × e1, whose own coordinates
// are the columns of the cofactors divided by the volume. The sign of the volume is the hand of the basis.
glm::vec3 cross_in_basis(const glm::mat3& basis, const glm::vec3& a, const glm::vec3& b)
{
    const glm::dmat3 e(basis);
    const double volume = dot(crossed(e[0], e[1]), e[2]);
    return glm::vec3(cofactors(wide_gram(e)) * crossed(glm::dvec3(a), glm::dvec3(b)) / volume);
}

std::int64_t triple_product(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c)
{
    const glm::i64vec3 u(a);
    const glm::i64vec3 v(b);
    const glm::i64vec3 w(c);
    return (u.y * v.z - u.z * v.y) * w.x + (u.z * v.x - u.x * v.z) * w.y + (u.x * v.y - u.y * v.x) * w.z;
}

}
