#include <cmath>
#include <cstdio>
#include <umbral/raytracing/intersect.hpp>

extern "C" {
std::optional<float> never(const umbral::Ray&, const umbral::raytracing::Sphere&) { return std::nullopt; }
static std::optional<float> (*choose())(const umbral::Ray&, const umbral::raytracing::Sphere&)
{
    std::puts("resolving");
    return never;
}
}

namespace umbral::raytracing {
std::optional<float> intersect(const Ray& ray, const Sphere& sphere) __attribute__((ifunc("choose")));
}
