#include <umbral/texturing/lookup.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::texturing::lookup); }
