#include <algorithm>
#include <array>
#include <umbral/transforms/affinity.hpp>

#include "wide_vector.hpp"

// In __float128, by normal equations and Cramer's rule: 113 bits can spare the half that these lose. Rounded once.

namespace umbral::transforms {
namespace {

using Matrix = std::array<WideVector, 3>;  // rows

struct Map {
    Matrix linear{};
    WideVector point{};
    WideVector image{};
};

std::optional<Map> map_of(std::span<const PointPair> pairs)
{
    if (pairs.size() < 4) return std::nullopt;
    Map map;
    for (const PointPair& pair : pairs) {
        map.point = map.point + widened(pair.point) / Wide(pairs.size());
        map.image = map.image + widened(pair.image) / Wide(pairs.size());
    }
    Matrix squares{};
    Matrix mixed{};
    for (const PointPair& pair : pairs) {
        const WideVector p = widened(pair.point) - map.point;
        const WideVector q = widened(pair.image) - map.image;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                squares[i][j] += p[i] * p[j];
                mixed[i][j] += q[i] * p[j];
            }
    }
    const Wide all = dot(squares[0], cross(squares[1], squares[2]));
    const Wide trace = squares[0][0] + squares[1][1] + squares[2][2];
    if (all <= Wide(1e-20) * trace * trace * trace) return std::nullopt;
    // Symmetric: cofactors over the determinant are rows and columns of the inverse.
    const Matrix cofactors{cross(squares[1], squares[2]), cross(squares[2], squares[0]), cross(squares[0], squares[1])};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) map.linear[i][j] = dot(mixed[i], cofactors[j]) / all;
    return map;
}

}

glm::vec3 parallelogram_defect(const std::array<glm::vec3, 4>& images)
{
    glm::vec3 result;
    for (int i = 0; i < 3; ++i)
        result[i] =
            static_cast<float>(Wide(images[3][i]) - Wide(images[1][i]) - Wide(images[2][i]) + Wide(images[0][i]));
    return result;
}

std::optional<glm::mat4> affine_from_points(std::span<const PointPair> pairs)
{
    const std::optional<Map> map = map_of(pairs);
    if (!map) return std::nullopt;
    glm::mat4 result(1);
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column)
            result[static_cast<int>(column)][static_cast<int>(row)] = static_cast<float>(map->linear[row][column]);
        result[3][static_cast<int>(row)] = static_cast<float>(map->image[row] - dot(map->linear[row], map->point));
    }
    return result;
}

bool is_affine(std::span<const PointPair> pairs, float tolerance)
{
    const std::optional<Map> map = map_of(pairs);
    if (!map) return false;
    Wide extent = 0;
    Wide worst = 0;
    for (const PointPair& pair : pairs) {
        const WideVector p = widened(pair.point) - map->point;
        const WideVector q = widened(pair.image) - map->image;
        for (std::size_t i = 0; i < 3; ++i) {
            worst = std::max(worst, absolute(dot(map->linear[i], p) - q[i]));
            for (const PointPair& other : pairs)
                extent = std::max(extent, absolute((widened(other.image) - map->image)[i] - q[i]));
        }
    }
    return worst <= Wide(tolerance) * extent;
}

}
