#include <umbral/interaction/three_mode_camera.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::interaction::make_three_mode_camera); }
