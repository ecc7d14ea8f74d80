// alternative: the textbook's subtraction a - (a·b / b·b) b and atan2, in long double
#include <cmath>
#include <umbral/transforms/vectors.hpp>

namespace umbral::transforms {
namespace {

using Long = long double;

Long sum_of_products(const glm::vec3& a, const glm::vec3& b)
{
    Long sum = 0;
    for (int i = 0; i < 3; ++i) sum += Long{a[i]} * Long{b[i]};
    return sum;
}

Long size(const glm::vec3& v) { return std::sqrt(sum_of_products(v, v)); }

/// How many times `b` the parallel part of `a` is.
Long share(const glm::vec3& a, const glm::vec3& b)
{
    const Long square = sum_of_products(b, b);
    return square > 0 ? sum_of_products(a, b) / square : 0;
}

Long minor(const glm::vec3& a, const glm::vec3& b, int i)
{
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    return Long{a[j]} * Long{b[k]} - Long{a[k]} * Long{b[j]};
}

}

float dot_product(const glm::vec3& a, const glm::vec3& b) { return static_cast<float>(sum_of_products(a, b)); }

glm::vec3 cross_product(const glm::vec3& a, const glm::vec3& b)
{
    return {minor(a, b, 0), minor(a, b, 1), minor(a, b, 2)};
}

float length_of(const glm::vec3& v) { return static_cast<float>(size(v)); }

glm::vec3 normalised(const glm::vec3& v)
{
    const Long length = size(v);
    return length > 0 ? glm::vec3(Long{v.x} / length, Long{v.y} / length, Long{v.z} / length) : glm::vec3(0);
}

float angle_between(const glm::vec3& a, const glm::vec3& b)
{
    const Long sine = std::hypot(minor(a, b, 0), minor(a, b, 1), minor(a, b, 2));
    return static_cast<float>(std::atan2(sine, sum_of_products(a, b)));
}

glm::vec3 parallel_part(const glm::vec3& a, const glm::vec3& b)
{
    const Long t = share(a, b);
    return {t * Long{b.x}, t * Long{b.y}, t * Long{b.z}};
}

glm::vec3 perpendicular_part(const glm::vec3& a, const glm::vec3& b)
{
    const Long t = share(a, b);
    return {Long{a.x} - t * Long{b.x}, Long{a.y} - t * Long{b.y}, Long{a.z} - t * Long{b.z}};
}

}
