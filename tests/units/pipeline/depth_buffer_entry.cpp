#include <umbral/pipeline/depth.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::pipeline::stored_depth); }
