#define length length_
#define distance distance_
#define dot dot_
#define cross cross_
#define normalize normalize_
#define faceforward faceforward_
#define reflect mine_a
#define refract mine_b
#define compute_length compute_length_
#define compute_distance compute_distance_
#define compute_dot compute_dot_
#define compute_cross compute_cross_
#define compute_normalize compute_normalize_
#define compute_faceforward compute_faceforward_
#define compute_reflect compute_reflect_
#define compute_refract compute_refract_
namespace glm {
template <length_t L, typename T, qualifier Q> T length_(vec<L, T, Q> const& v);
template <length_t L, typename T, qualifier Q> T dot_(vec<L, T, Q> const& x, vec<L, T, Q> const& y);
template <typename T> T dot_(T x, T y);
}
#include <glm/detail/func_geometric.inl>
#undef length
#undef distance
#undef dot
#undef cross
#undef normalize
#undef faceforward
#undef reflect
#undef refract
#include <umbral/raytracing/reflect_refract.hpp>
namespace umbral::raytracing {
glm::vec3 mirrored_direction(const glm::vec3& v, const glm::vec3& n)
{
    return glm::vec3(glm::mine_a(-glm::normalize(glm::dvec3(v)), glm::normalize(glm::dvec3(n))));
}
std::optional<glm::vec3> refracted_direction(const glm::vec3& v, const glm::vec3& n, float outside, float inside)
{
    glm::dvec3 normal = glm::normalize(glm::dvec3(n));
    const glm::dvec3 viewer = glm::normalize(glm::dvec3(v));
    double ratio = double(outside) / inside;
    if (dot(viewer, normal) < 0) { normal = -normal; ratio = double(inside) / outside; }
    const glm::dvec3 there = glm::mine_b(-viewer, normal, ratio);
    if (there == glm::dvec3(0)) return std::nullopt;
    return glm::vec3(there);
}
std::optional<float> critical_angle(float from, float into)
{
    if (into >= from) return std::nullopt;
    return std::asin(double(into) / from);
}
}
