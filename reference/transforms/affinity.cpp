// Based on: Å. Björck. Solving Linear Least Squares Problems by Gram-Schmidt Orthogonalization. BIT 7, 1967: modified
// Gram-Schmidt with the right sides orthogonalised along is as stable as Householder's method. Normal equations square
// what nearly dependent points lose.

#include <algorithm>
#include <array>
#include <cmath>
#include <umbral/transforms/affinity.hpp>
#include <utility>
#include <vector>

namespace umbral::transforms {
namespace {

using Column = std::vector<double>;
using Columns = std::array<Column, 3>;

constexpr double thinnest = 1e-9;

/// One coordinate after the other, seen from the mean, which is returned.
glm::dvec3 centre(std::span<const PointPair> pairs, glm::vec3 PointPair::*member, Columns& columns)
{
    const auto count = static_cast<double>(pairs.size());
    glm::dvec3 mean(0);
    // Seen from the first one, so that nothing far away is summed up.
    const glm::dvec3 first(pairs.front().*member);
    for (const PointPair& pair : pairs) mean += (glm::dvec3(pair.*member) - first) / count;
    for (int axis = 0; axis < 3; ++axis)
        for (const PointPair& pair : pairs)
            columns[axis].push_back(double{(pair.*member)[axis]} - first[axis] - mean[axis]);
    return first + mean;
}

double dot(const Column& a, const Column& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// Takes away from `column` its part along `unit`, which is returned.
double take_part(Column& column, const Column& unit)
{
    const double part = dot(unit, column);
    for (std::size_t i = 0; i < column.size(); ++i) column[i] -= part * unit[i];
    return part;
}

/// The linear map A that brings A · points nearest to the images, both columns of coordinates; nothing if the points
/// lie in a plane.
std::optional<glm::dmat3> nearest_linear_map(Columns points, Columns images)
{
    const double extent = std::sqrt(dot(points[0], points[0]) + dot(points[1], points[1]) + dot(points[2], points[2]));
    double triangle[3][3] = {};
    double parts[3][3] = {};  // of each coordinate of the images along each unit vector
    for (std::size_t k = 0; k < 3; ++k) {
        Column& unit = points[k];
        // What is left of a column is at least as long as the layer is thick.
        triangle[k][k] = std::sqrt(dot(unit, unit));
        if (triangle[k][k] <= thinnest * extent) return std::nullopt;
        for (double& number : unit) number /= triangle[k][k];
        for (std::size_t j = k + 1; j < 3; ++j) triangle[k][j] = take_part(points[j], unit);
        for (std::size_t axis = 0; axis < 3; ++axis) parts[axis][k] = take_part(images[axis], unit);
    }
    glm::dmat3 map;
    for (int axis = 0; axis < 3; ++axis) {
        for (int k = 2; k >= 0; --k) {
            double rest = parts[axis][k];
            for (int j = k + 1; j < 3; ++j) rest -= triangle[k][j] * map[j][axis];
            map[k][axis] = rest / triangle[k][k];
        }
    }
    return map;
}

struct AffineMap {
    glm::dmat3 linear;
    glm::dvec3 point;  ///< goes to …
    glm::dvec3 image;  ///< … here
};

/// The best map takes the points' mean to the images' mean; what is left is linear.
std::optional<AffineMap> nearest_affine_map(std::span<const PointPair> pairs)
{
    if (pairs.size() < 4) return std::nullopt;
    Columns points;
    Columns images;
    const glm::dvec3 point = centre(pairs, &PointPair::point, points);
    const glm::dvec3 image = centre(pairs, &PointPair::image, images);
    const std::optional<glm::dmat3> linear = nearest_linear_map(std::move(points), std::move(images));
    if (!linear) return std::nullopt;
    return AffineMap{*linear, point, image};
}

}

glm::vec3 parallelogram_defect(const std::array<glm::vec3, 4>& images)
{
    return glm::vec3((glm::dvec3(images[3]) - glm::dvec3(images[1])) - (glm::dvec3(images[2]) - glm::dvec3(images[0])));
}

std::optional<glm::mat4> affine_from_points(std::span<const PointPair> pairs)
{
    const std::optional<AffineMap> map = nearest_affine_map(pairs);
    if (!map) return std::nullopt;
    glm::mat4 result(glm::mat3(map->linear));
    result[3] = glm::vec4(map->image - map->linear * map->point, 1);
    return result;
}

bool is_affine(std::span<const PointPair> pairs, float tolerance)
{
    const std::optional<AffineMap> map = nearest_affine_map(pairs);
    if (!map) return false;
    glm::dvec3 low(pairs.front().image);
    glm::dvec3 high = low;
    for (const PointPair& pair : pairs) {
        low = glm::min(low, glm::dvec3(pair.image));
        high = glm::max(high, glm::dvec3(pair.image));
    }
    const glm::dvec3 sides = high - low;
    const double allowed = double{tolerance} * std::max({sides.x, sides.y, sides.z});
    return std::all_of(pairs.begin(), pairs.end(), [&](const PointPair& pair) {
        const glm::dvec3 missed =
            map->linear * (glm::dvec3(pair.point) - map->point) - (glm::dvec3(pair.image) - map->image);
        return std::max({std::abs(missed.x), std::abs(missed.y), std::abs(missed.z)}) <= allowed;
    });
}

}
