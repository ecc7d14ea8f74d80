#include <umbral/raytracing/reflect_refract.hpp>
#define NUMBER Nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn
struct NUMBER {
    double v = 0;
    constexpr NUMBER() = default;
    constexpr NUMBER(double x) : v(x) {}
    explicit constexpr operator double() const { return v; }
    explicit constexpr operator float() const { return float(v); }
    NUMBER& operator+=(NUMBER o) { v += o.v; return *this; }
    NUMBER& operator-=(NUMBER o) { v -= o.v; return *this; }
    NUMBER& operator*=(NUMBER o) { v *= o.v; return *this; }
    friend constexpr NUMBER operator+(NUMBER a, NUMBER b) { return a.v + b.v; }
    friend constexpr NUMBER operator-(NUMBER a, NUMBER b) { return a.v - b.v; }
    friend constexpr NUMBER operator*(NUMBER a, NUMBER b) { return a.v * b.v; }
    friend constexpr NUMBER operator-(NUMBER a) { return -a.v; }
    friend constexpr bool operator>=(NUMBER a, NUMBER b) { return a.v >= b.v; }
};
template <> struct std::numeric_limits<NUMBER> : std::numeric_limits<double> {};
namespace umbral::raytracing {
namespace {
using V = glm::vec<3, NUMBER, glm::defaultp>;
V wide(const glm::vec3& a) { const glm::dvec3 u = glm::normalize(glm::dvec3(a)); return V(NUMBER(u.x), NUMBER(u.y), NUMBER(u.z)); }
glm::vec3 narrow(const V& a) { return {float(a.x.v), float(a.y.v), float(a.z.v)}; }
}
glm::vec3 mirrored_direction(const glm::vec3& v, const glm::vec3& n) { return narrow(glm::reflect(-wide(v), wide(n))); }
std::optional<glm::vec3> refracted_direction(const glm::vec3& v, const glm::vec3& n, float outside, float inside)
{
    glm::dvec3 normal = glm::normalize(glm::dvec3(n));
    double ratio = double(outside) / inside;
    if (dot(glm::dvec3(v), normal) < 0) { normal = -normal; ratio = double(inside) / outside; }
    const glm::dvec3 viewer = glm::normalize(glm::dvec3(v));
    normal = glm::normalize(normal);
    const glm::dvec3 along = ratio * (dot(normal, viewer) * normal - viewer);
    if (dot(along, along) > 1) return std::nullopt;
    return glm::vec3(along - std::sqrt(1 - dot(along, along)) * normal);
}
std::optional<float> critical_angle(float from, float into)
{
    if (into >= from) return std::nullopt;
    return std::asin(double(into) / from);
}
}
