#include <umbral/pipeline/clip.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::pipeline::clip_triangle); }
