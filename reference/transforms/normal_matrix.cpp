// Based on: E. Lengyel. Foundations of Game Engine Development, volume 1: Mathematics, section 3.2.2. 2016: normals go
// by the cofactors, which exist for every matrix; the sign of the determinant keeps the outside outside in mirrors.

#include <algorithm>
#include <cmath>
#include <umbral/transforms/normal_matrix.hpp>

namespace umbral::transforms {
namespace {

// In double, which holds the product of three floats whatever their size. The columns of the cofactors are the areas
// that the columns of A span.
glm::dmat3 cofactors_outwards(const glm::mat4& model)
{
    const glm::dmat3 a{glm::mat3(model)};
    const glm::dmat3 cofactors(cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1]));
    const double determinant = dot(a[0], cofactors[0]);
    return determinant < 0 ? -cofactors : cofactors;
}

}

glm::mat3 normal_matrix(const glm::mat4& model)
{
    const glm::dmat3 u = cofactors_outwards(model);
    double largest = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(u[column][row]));
    return largest > 0 ? glm::mat3(u / largest) : glm::mat3(0);
}

glm::vec3 transformed_normal(const glm::mat4& model, const glm::vec3& normal)
{
    const glm::dvec3 n = cofactors_outwards(model) * glm::dvec3(normal);
    const double size = length(n);
    return size > 0 ? glm::vec3(n / size) : glm::vec3(0);
}

}
