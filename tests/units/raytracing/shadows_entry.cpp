#include <umbral/raytracing/shadows.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::raytracing::sees_light); }
