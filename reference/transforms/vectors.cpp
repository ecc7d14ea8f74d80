// Based on: W. Kahan. How Futile are Mindless Assessments of Roundoff in Floating-Point Computation? 2006, for the
// angle, and T. J. Dekker. A Floating-Point Technique for Extending the Available Precision. 1971: the product of two
// floats is exact in double.

#include <cmath>
#include <umbral/transforms/vectors.hpp>

namespace umbral::transforms {
namespace {

using Wide = glm::dvec3;

// In double, no product of two floats rounds, and neither it nor its square overflows or vanishes.
double wide_dot(const Wide& a, const Wide& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Wide wide_cross(const Wide& a, const Wide& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double wide_length(const Wide& v) { return std::sqrt(wide_dot(v, v)); }

bool is_null(const glm::vec3& v) { return v == glm::vec3(0); }

}

float dot_product(const glm::vec3& a, const glm::vec3& b) { return static_cast<float>(wide_dot(Wide(a), Wide(b))); }

glm::vec3 cross_product(const glm::vec3& a, const glm::vec3& b) { return glm::vec3(wide_cross(Wide(a), Wide(b))); }

float length_of(const glm::vec3& v) { return static_cast<float>(wide_length(Wide(v))); }

glm::vec3 normalised(const glm::vec3& v) { return is_null(v) ? v : glm::vec3(Wide(v) / wide_length(Wide(v))); }

// |a||b| sinα and |a||b| cosα: of the two, one always says the angle with all its digits. Beside a null vector the
// cosine may be -0, and the angle π.
float angle_between(const glm::vec3& a, const glm::vec3& b)
{
    if (is_null(a) || is_null(b)) return 0;
    return static_cast<float>(std::atan2(wide_length(wide_cross(Wide(a), Wide(b))), wide_dot(Wide(a), Wide(b))));
}

glm::vec3 parallel_part(const glm::vec3& a, const glm::vec3& b)
{
    return is_null(b) ? b : glm::vec3(wide_dot(Wide(a), Wide(b)) / wide_dot(Wide(b), Wide(b)) * Wide(b));
}

// b × (a × b) = (b·b) a - (a·b) b: the same vector without subtracting one long vector from another.
glm::vec3 perpendicular_part(const glm::vec3& a, const glm::vec3& b)
{
    return is_null(b) ? a : glm::vec3(wide_cross(Wide(b), wide_cross(Wide(a), Wide(b))) / wide_dot(Wide(b), Wide(b)));
}

}
