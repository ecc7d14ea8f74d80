#include <umbral/interaction/camera_animation.hpp>

extern "C" void* unit_entry() { return reinterpret_cast<void*>(&umbral::interaction::flight_view); }
