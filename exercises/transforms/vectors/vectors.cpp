#include <umbral/transforms/vectors.hpp>

namespace umbral::transforms {

float dot_product(const glm::vec3& a, const glm::vec3& b)
{
    // TODO: the sum of the three products.
    return not_implemented<float>(a, b);
}

glm::vec3 cross_product(const glm::vec3& a, const glm::vec3& b)
{
    // TODO: x of the result is a.y * b.z - a.z * b.y; the others follow in the order x → y → z → x.
    return not_implemented<glm::vec3>(a, b);
}

float length_of(const glm::vec3& v)
{
    // TODO: the root of v·v. Mind vectors whose square is no float.
    return not_implemented<float>(v);
}

glm::vec3 normalised(const glm::vec3& v)
{
    // TODO: v divided by its length; the null vector stays null.
    return not_implemented<glm::vec3>(v);
}

float angle_between(const glm::vec3& a, const glm::vec3& b)
{
    // TODO: |a × b| is |a||b| times the sine, a·b is |a||b| times the cosine.
    return not_implemented<float>(a, b);
}

glm::vec3 parallel_part(const glm::vec3& a, const glm::vec3& b)
{
    // TODO: ((a·b) / (b·b)) b. The null vector has no direction: nothing is parallel to it.
    return not_implemented<glm::vec3>(a, b);
}

glm::vec3 perpendicular_part(const glm::vec3& a, const glm::vec3& b)
{
    // TODO: what is left of a.
    return not_implemented<glm::vec3>(a, b);
}

}
