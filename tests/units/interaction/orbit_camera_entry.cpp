#include <umbral/interaction/orbit_camera.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::interaction::make_orbit_camera); }
