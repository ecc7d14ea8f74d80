// mistake: multiplies the inverse transpose of the whole 4 × 4 with (n, 1)
// credit: 40..62
// hint: Your normals depend on the translation. They are free vectors: w is 0, and only the upper left 3 × 3 counts.
#include <umbral/transforms/normal_matrix.hpp>

namespace umbral::transforms {
namespace {

glm::dvec3 carried(const glm::dmat3& u, const glm::dvec3& offset, const glm::dvec3& n) { return u * n + u * offset; }

}

glm::mat3 normal_matrix(const glm::mat4& model)
{
    const glm::dmat3 a{glm::mat3(model)};
    const glm::dmat3 cofactors(cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1]));
    const glm::dmat3 u = dot(a[0], cofactors[0]) < 0 ? -cofactors : cofactors;
    const double size = std::max({length(u[0]), length(u[1]), length(u[2])});
    return size > 0 ? glm::mat3(u / size) : glm::mat3(0);
}

glm::vec3 transformed_normal(const glm::mat4& model, const glm::vec3& normal)
{
    const glm::dvec3 n = carried(glm::dmat3(normal_matrix(model)), glm::dvec3(model[3]), glm::dvec3(normal));
    return n == glm::dvec3(0) ? glm::vec3(0) : glm::vec3(normalize(n));
}

}
