// alternative: normal equations by Cramer's rule, in long double
#include <algorithm>
#include <cmath>
#include <umbral/transforms/affinity.hpp>

namespace umbral::transforms {
namespace {

using Number = long double;
using Vector = glm::vec<3, Number>;
using Matrix = glm::mat<3, 3, Number>;

struct Map {
    Matrix linear;
    Vector point;
    Vector image;
};

std::optional<Map> map_of(std::span<const PointPair> pairs)
{
    if (pairs.size() < 4) return std::nullopt;
    const auto count = static_cast<Number>(pairs.size());
    Vector point(0);
    Vector image(0);
    for (const PointPair& pair : pairs) {
        point += Vector(pair.point) / count;
        image += Vector(pair.image) / count;
    }
    Matrix squares(0);
    Matrix mixed(0);
    for (const PointPair& pair : pairs) {
        const Vector p = Vector(pair.point) - point;
        squares += glm::outerProduct(p, p);
        mixed += glm::outerProduct(Vector(pair.image) - image, p);
    }
    const Number size = (squares[0][0] + squares[1][1] + squares[2][2]) / 3;
    const Matrix shape = squares / size;
    if (!(glm::determinant(shape) > Number(1e-17))) return std::nullopt;
    return Map{mixed / size * glm::inverse(shape), point, image};
}

}

glm::vec3 parallelogram_defect(const std::array<glm::vec3, 4>& images)
{
    return glm::vec3((Vector(images[3]) - Vector(images[1])) - (Vector(images[2]) - Vector(images[0])));
}

std::optional<glm::mat4> affine_from_points(std::span<const PointPair> pairs)
{
    const std::optional<Map> map = map_of(pairs);
    if (!map) return std::nullopt;
    const Vector origin = map->image - map->linear * map->point;
    return glm::mat4{glm::vec4(glm::vec3(map->linear[0]), 0), glm::vec4(glm::vec3(map->linear[1]), 0),
                     glm::vec4(glm::vec3(map->linear[2]), 0), glm::vec4(glm::vec3(origin), 1)};
}

bool is_affine(std::span<const PointPair> pairs, float tolerance)
{
    const std::optional<Map> map = map_of(pairs);
    if (!map) return false;
    Number extent = 0;
    Number worst = 0;
    for (const PointPair& pair : pairs) {
        const Vector missed = map->linear * (Vector(pair.point) - map->point) - (Vector(pair.image) - map->image);
        for (int axis = 0; axis < 3; ++axis) {
            worst = std::max(worst, std::abs(missed[axis]));
            for (const PointPair& other : pairs)
                extent = std::max(extent, std::abs(Number(other.image[axis]) - Number(pair.image[axis])));
        }
    }
    return worst <= Number(tolerance) * extent;
}

}
