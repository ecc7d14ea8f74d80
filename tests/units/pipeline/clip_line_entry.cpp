#include <umbral/pipeline/clip_line.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::pipeline::clip_segment); }
