#include <umbral/raytracing/intersect.hpp>
namespace umbral::raytracing {
std::optional<float> intersect(const Ray&, const Sphere&) { return 1; }
}
