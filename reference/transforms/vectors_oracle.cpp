#include <cmath>
#include <umbral/transforms/vectors.hpp>

#include "wide.hpp"

// In __float128, rounded to float once.

namespace umbral::transforms {
namespace {

struct Vector {
    Wide x, y, z;
};

Vector widened(const glm::vec3& v) { return {v.x, v.y, v.z}; }
glm::vec3 rounded(const Vector& v)
{
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
Wide dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(const Vector& a, const Vector& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vector scaled(Wide factor, const Vector& v) { return {factor * v.x, factor * v.y, factor * v.z}; }
bool is_null(const glm::vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

}

float dot_product(const glm::vec3& a, const glm::vec3& b) { return static_cast<float>(dot(widened(a), widened(b))); }

glm::vec3 cross_product(const glm::vec3& a, const glm::vec3& b) { return rounded(cross(widened(a), widened(b))); }

float length_of(const glm::vec3& v) { return static_cast<float>(square_root(dot(widened(v), widened(v)))); }

glm::vec3 normalised(const glm::vec3& v)
{
    return is_null(v) ? v : rounded(scaled(1 / square_root(dot(widened(v), widened(v))), widened(v)));
}

float angle_between(const glm::vec3& a, const glm::vec3& b)
{
    if (is_null(a) || is_null(b)) return 0;
    const Vector normal = cross(widened(a), widened(b));
    // The sine and cosine times |a||b|, in long double: 64 bits are enough for one rounding to 24.
    return static_cast<float>(std::atan2(static_cast<long double>(square_root(dot(normal, normal))),
                                         static_cast<long double>(dot(widened(a), widened(b)))));
}

glm::vec3 parallel_part(const glm::vec3& a, const glm::vec3& b)
{
    const Vector along = widened(b);
    return is_null(b) ? b : rounded(scaled(dot(widened(a), along) / dot(along, along), along));
}

// The sum of the squares times the vector, less its parallel part times that sum: exact zeros stay exact.
glm::vec3 perpendicular_part(const glm::vec3& a, const glm::vec3& b)
{
    if (is_null(b)) return a;
    const Vector along = widened(b);
    const Wide square = dot(along, along);
    const Vector long_way = scaled(square, widened(a));
    const Vector taken = scaled(dot(widened(a), along), along);
    return rounded(scaled(1 / square, {long_way.x - taken.x, long_way.y - taken.y, long_way.z - taken.z}));
}

}
