#include <umbral/pipeline/clip_polygon.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::pipeline::clip_polygon); }
