// Based on: C. Ureña. Informática Gráfica, tema 2, "matrices de transformación usuales". 2021; GLM stores columns:
// m[column][row].

#include <cmath>
#include <umbral/transforms/basic_matrices.hpp>

namespace umbral::transforms {
namespace {

// Turns coordinate `from` towards coordinate `to`, and leaves the third one alone.
glm::mat4 turned(int from, int to, float angle)
{
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    glm::mat4 m(1);
    m[from][from] = c;
    m[from][to] = s;
    m[to][from] = -s;
    m[to][to] = c;
    return m;
}

}

glm::mat4 translation_matrix(const glm::vec3& offset)
{
    glm::mat4 m(1);
    m[3] = glm::vec4(offset, 1);
    return m;
}

glm::mat4 scaling_matrix(const glm::vec3& factors)
{
    glm::mat4 m(1);
    for (int i = 0; i < 3; ++i) m[i][i] = factors[i];
    return m;
}

glm::mat4 shear_matrix(int moved, int by, float amount)
{
    glm::mat4 m(1);
    m[by][moved] = amount;
    return m;
}

glm::mat4 rotation_about_x(float angle) { return turned(1, 2, angle); }
glm::mat4 rotation_about_y(float angle) { return turned(2, 0, angle); }
glm::mat4 rotation_about_z(float angle) { return turned(0, 1, angle); }

glm::vec3 transform_point(const glm::mat4& matrix, const glm::vec3& point)
{
    return glm::vec3(matrix * glm::vec4(point, 1));
}

glm::vec3 transform_vector(const glm::mat4& matrix, const glm::vec3& vector)
{
    return glm::vec3(matrix * glm::vec4(vector, 0));
}

glm::mat4 compose_matrices(std::span<const glm::mat4> steps)
{
    glm::mat4 all(1);
    for (const glm::mat4& step : steps) all = step * all;
    return all;
}

}
