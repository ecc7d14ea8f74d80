#include "light_direction_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::lighting;
    static LightDirection functions = {light_direction, light_angles, direction_in_camera, direction_in_world,
                                       make_light_control};
    return &functions;
}
