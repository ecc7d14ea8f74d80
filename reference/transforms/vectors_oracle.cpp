#include <cmath>
#include <umbral/transforms/vectors.hpp>

#include "wide_vector.hpp"

// In __float128, rounded to float once.

namespace umbral::transforms {
float dot_product(const glm::vec3& a, const glm::vec3& b) { return static_cast<float>(dot(widened(a), widened(b))); }

glm::vec3 cross_product(const glm::vec3& a, const glm::vec3& b) { return rounded(cross(widened(a), widened(b))); }

float length_of(const glm::vec3& v) { return static_cast<float>(length(widened(v))); }

glm::vec3 normalised(const glm::vec3& v) { return is_null(widened(v)) ? v : rounded(unit(widened(v))); }

float angle_between(const glm::vec3& a, const glm::vec3& b)
{
    if (is_null(widened(a)) || is_null(widened(b))) return 0;
    const WideVector normal = cross(widened(a), widened(b));
    // The sine and cosine times |a||b|, in long double: 64 bits are enough for one rounding to 24.
    return static_cast<float>(
        std::atan2(static_cast<long double>(length(normal)), static_cast<long double>(dot(widened(a), widened(b)))));
}

glm::vec3 parallel_part(const glm::vec3& a, const glm::vec3& b)
{
    const WideVector along = widened(b);
    return is_null(along) ? b : rounded(dot(widened(a), along) / dot(along, along) * along);
}

// The sum of the squares times the vector, less its parallel part times that sum: exact zeros stay exact.
glm::vec3 perpendicular_part(const glm::vec3& a, const glm::vec3& b)
{
    const WideVector along = widened(b);
    if (is_null(along)) return a;
    const Wide square = dot(along, along);
    return rounded((square * widened(a) - dot(widened(a), along) * along) / square);
}

}
