#include "pick_ray_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::interaction;
    static PickRayFunctions functions = {pick_pixel, pick_ray};
    return &functions;
}
