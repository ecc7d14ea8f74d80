// alternative: matrices written row by row, as on paper, and transposed; products by hand, in double
#include <cmath>
#include <umbral/transforms/basic_matrices.hpp>

namespace umbral::transforms {
namespace {

/// The three upper rows, as one writes them.
glm::mat4 rows(const glm::vec4& x, const glm::vec4& y, const glm::vec4& z)
{
    return glm::transpose(glm::mat4(x, y, z, glm::vec4(0, 0, 0, 1)));
}

glm::vec3 times(const glm::mat4& m, const glm::vec3& v, double w)
{
    glm::dvec3 sum = w * glm::dvec3(m[3]);
    for (int i = 0; i < 3; ++i) sum += double{v[i]} * glm::dvec3(m[i]);
    return glm::vec3(sum);
}

}

glm::mat4 translation_matrix(const glm::vec3& d) { return rows({1, 0, 0, d.x}, {0, 1, 0, d.y}, {0, 0, 1, d.z}); }
glm::mat4 scaling_matrix(const glm::vec3& s) { return rows({s.x, 0, 0, 0}, {0, s.y, 0, 0}, {0, 0, s.z, 0}); }

glm::mat4 shear_matrix(int moved, int by, float amount)
{
    glm::mat4 upright(1);
    upright[moved][by] = amount;
    return glm::transpose(upright);
}

glm::mat4 rotation_about_x(float angle)
{
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    return rows({1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0});
}

glm::mat4 rotation_about_y(float angle)
{
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    return rows({c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0});
}

glm::mat4 rotation_about_z(float angle)
{
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    return rows({c, -s, 0, 0}, {s, c, 0, 0}, {0, 0, 1, 0});
}

glm::vec3 transform_point(const glm::mat4& matrix, const glm::vec3& point) { return times(matrix, point, 1); }
glm::vec3 transform_vector(const glm::mat4& matrix, const glm::vec3& vector) { return times(matrix, vector, 0); }

glm::mat4 compose_matrices(std::span<const glm::mat4> steps)
{
    glm::dmat4 all(1);
    for (std::size_t i = steps.size(); i > 0; --i) all = all * glm::dmat4(steps[i - 1]);
    return glm::mat4(all);
}

}
