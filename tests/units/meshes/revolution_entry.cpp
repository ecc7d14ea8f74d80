#include <umbral/meshes/revolution.hpp>

extern "C" const void* unit_entry() { return reinterpret_cast<const void*>(&umbral::meshes::revolve); }
