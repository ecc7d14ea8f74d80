#include <umbral/raytracing/disc.hpp>

extern "C" void* unit_entry()
{
    using namespace umbral;
    using namespace umbral::raytracing;
    return reinterpret_cast<void*>(static_cast<std::optional<float> (*)(const Ray&, const Disc&)>(&intersect));
}
