#include <umbral/raytracing/triangle.hpp>

extern "C" void* unit_entry()
{
    using namespace umbral;
    using namespace umbral::raytracing;
    using Intersect = std::optional<TriangleHit>(const Ray&, const Triangle&);
    return reinterpret_cast<void*>(static_cast<Intersect*>(&intersect));
}
