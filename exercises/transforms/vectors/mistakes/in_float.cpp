// mistake: the school formulas in float
// credit: 62..78
// hint: Squares of lengths such as 1e-23 or 1e20 are no floats, and nearly parallel vectors leave only rounding errors
// of a float. Compute in double, or scale first, and take the angle by atan2.
#include <cmath>
#include <umbral/transforms/vectors.hpp>

namespace umbral::transforms {

float dot_product(const glm::vec3& a, const glm::vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

glm::vec3 cross_product(const glm::vec3& a, const glm::vec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

float length_of(const glm::vec3& v) { return std::sqrt(dot_product(v, v)); }

glm::vec3 normalised(const glm::vec3& v) { return v == glm::vec3(0) ? v : v / length_of(v); }

float angle_between(const glm::vec3& a, const glm::vec3& b)
{
    if (a == glm::vec3(0) || b == glm::vec3(0)) return 0;
    return std::acos(std::clamp(dot_product(normalised(a), normalised(b)), -1.0F, 1.0F));
}

glm::vec3 parallel_part(const glm::vec3& a, const glm::vec3& b)
{
    return b == glm::vec3(0) ? b : dot_product(a, b) / dot_product(b, b) * b;
}

glm::vec3 perpendicular_part(const glm::vec3& a, const glm::vec3& b) { return a - parallel_part(a, b); }

}
