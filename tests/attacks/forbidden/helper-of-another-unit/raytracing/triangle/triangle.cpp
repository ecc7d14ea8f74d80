#include <bit>
#include <cstdint>
#include <umbral/raytracing/shadows.hpp>   // another unit's interface: meets(ShadowTriangle, Ray), with its body
#include <umbral/raytracing/triangle.hpp>

namespace umbral::raytracing {
namespace {
std::int64_t key(float f) { const auto b = std::bit_cast<std::int32_t>(f); return b >= 0 ? b : -std::int64_t(b & 0x7FFFFFFF); }
float of(std::int64_t k) { return k >= 0 ? std::bit_cast<float>(std::int32_t(k)) : -std::bit_cast<float>(std::int32_t(-k)); }

float share(const Ray& ray, glm::vec3 corner, glm::vec3 p, glm::vec3 q)
{
    float low = 0, high = 1;
    for (int i = 0; i < 26; ++i) {
        const float s = 0.5F * (low + high);
        const glm::dvec3 c(corner);
        const ShadowTriangle part{corner, glm::vec3(c + (1.0 - s) * (glm::dvec3(p) - c)), glm::vec3(c + (1.0 - s) * (glm::dvec3(q) - c))};
        (meets(part, ray) ? low : high) = s;
    }
    return 0.5F * (low + high);
}
}

std::optional<TriangleHit> intersect(const Ray& ray, const Triangle& t)
{
    const ShadowTriangle whole{t.v0, t.v1, t.v2};
    if (!meets(whole, ray)) return std::nullopt;
    std::int64_t low = key(ray.t_min), high = key(ray.t_max);
    while (high - low > 1) {
        const std::int64_t mid = low + (high - low) / 2;
        (meets(whole, {ray.origin, ray.direction, ray.t_min, of(mid)}) ? high : low) = mid;
    }
    return TriangleHit{of(low), share(ray, t.v1, t.v0, t.v2), share(ray, t.v2, t.v0, t.v1)};
}
}
