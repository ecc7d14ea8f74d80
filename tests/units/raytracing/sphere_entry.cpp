#include <umbral/raytracing/intersect.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::raytracing::intersect); }
