// alternative: the cross product of two transformed tangents, and the matrix from the normals of the axes
#include <cmath>
#include <umbral/transforms/normal_matrix.hpp>

namespace umbral::transforms {
namespace {

using Vector = glm::vec<3, long double>;
using Matrix = glm::mat<3, 3, long double>;

// A normal n is t × s for two tangents; the new one is (A t) × (A s), turned outwards again if A is a mirror.
Vector carried(const Matrix& a, const Vector& n)
{
    const Vector helper = std::abs(n.x) < std::abs(n.y) ? Vector(1, 0, 0) : Vector(0, 1, 0);
    const Vector t = cross(helper, n);
    const Vector s = cross(n, t);  // t × s = (t·t) n
    const long double volume = determinant(a);
    return (volume < 0 ? -1.0L : 1.0L) / dot(t, t) * cross(a * t, a * s);
}

}

glm::mat3 normal_matrix(const glm::mat4& model)
{
    const Matrix a{glm::mat3(model)};
    Vector columns[3];
    long double size = 0;
    for (int i = 0; i < 3; ++i) {
        Vector axis(0);
        axis[i] = 1;
        columns[i] = carried(a, axis);
        size = std::max(size, length(columns[i]));
    }
    glm::mat3 result(0);
    for (int i = 0; i < 3 && size > 0; ++i) result[i] = glm::vec3(columns[i] / size);
    return result;
}

glm::vec3 transformed_normal(const glm::mat4& model, const glm::vec3& normal)
{
    if (normal == glm::vec3(0)) return normal;
    const Vector n = carried(Matrix(glm::mat3(model)), Vector(normal));
    return n == Vector(0) ? glm::vec3(0) : glm::vec3(n / length(n));
}

}
