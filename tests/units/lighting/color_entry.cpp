#include "color_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::lighting;
    static ColorFunctions functions = {add_lights, encode_srgb, decode_srgb, to_pixel, to_light, mean_pixel};
    return &functions;
}
