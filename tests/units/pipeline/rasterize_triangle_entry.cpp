#include <umbral/pipeline/rasterize.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::pipeline::rasterize_triangle); }
