#include <umbral/texturing/coordinates.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::texturing::spherical_coordinates); }
