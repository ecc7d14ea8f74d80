#include <array>
#include <cmath>
#include <umbral/transforms/normal_matrix.hpp>

#include "wide.hpp"

// Cofactor by cofactor in __float128, which holds a product of three floats exactly; rounded to float once.

namespace umbral::transforms {
namespace {

using Matrix = std::array<std::array<Wide, 3>, 3>;  // by rows

Matrix cofactors_outwards(const glm::mat4& model)
{
    Matrix a;
    Matrix u;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            a[row][column] = model[static_cast<int>(column)][static_cast<int>(row)];
    // Going on from row and column in a circle, the signs + - + come by themselves.
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            const auto& next = a[(row + 1) % 3];
            const auto& last = a[(row + 2) % 3];
            u[row][column] =
                next[(column + 1) % 3] * last[(column + 2) % 3] - next[(column + 2) % 3] * last[(column + 1) % 3];
        }
    }
    const Wide determinant = a[0][0] * u[0][0] + a[0][1] * u[0][1] + a[0][2] * u[0][2];
    if (determinant < 0)
        for (auto& row : u)
            for (Wide& entry : row) entry = -entry;
    return u;
}

}

glm::mat3 normal_matrix(const glm::mat4& model)
{
    const Matrix u = cofactors_outwards(model);
    Wide largest = 0;
    for (const auto& row : u)
        for (const Wide entry : row) largest = std::max(largest, absolute(entry));
    glm::mat3 result(0);
    if (largest == 0) return result;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            result[static_cast<int>(column)][static_cast<int>(row)] = static_cast<float>(u[row][column] / largest);
    return result;
}

glm::vec3 transformed_normal(const glm::mat4& model, const glm::vec3& normal)
{
    const Matrix u = cofactors_outwards(model);
    Wide n[3];
    for (std::size_t row = 0; row < 3; ++row)
        n[row] = u[row][0] * Wide(normal.x) + u[row][1] * Wide(normal.y) + u[row][2] * Wide(normal.z);
    const Wide largest = std::max(absolute(n[0]), std::max(absolute(n[1]), absolute(n[2])));
    if (largest == 0) return glm::vec3(0);
    long double square = 0;
    for (Wide& component : n) {
        component /= largest;
        square += static_cast<long double>(component * component);
    }
    const long double length = std::sqrt(square);
    return {static_cast<float>(n[0] / Wide(length)), static_cast<float>(n[1] / Wide(length)),
            static_cast<float>(n[2] / Wide(length))};
}

}
