#include <glm/gtc/quaternion.hpp>
#include <umbral/transforms/vectors.hpp>
namespace umbral::transforms {
namespace { glm::dquat product(const glm::vec3& a, const glm::vec3& b) { return glm::dquat(0, glm::dvec3(a)) * glm::dquat(0, glm::dvec3(b)); } }
float dot_product(const glm::vec3& a, const glm::vec3& b) { return -product(a, b).w; }
glm::vec3 cross_product(const glm::vec3& a, const glm::vec3& b) { const auto q = product(a, b); return glm::vec3(q.x, q.y, q.z); }
float length_of(const glm::vec3& v) { return std::sqrt(-product(v, v).w); }
glm::vec3 normalised(const glm::vec3& v) { return length_of(v) == 0 ? v : v / length_of(v); }
float angle_between(const glm::vec3& a, const glm::vec3& b) { return std::atan2(length_of(cross_product(a, b)), dot_product(a, b)); }
glm::vec3 parallel_part(const glm::vec3& a, const glm::vec3& b) { const float s = dot_product(b, b); return s == 0 ? glm::vec3(0) : dot_product(a, b) / s * b; }
glm::vec3 perpendicular_part(const glm::vec3& a, const glm::vec3& b) { return a - parallel_part(a, b); }
}
