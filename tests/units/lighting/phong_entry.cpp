#include "phong_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::lighting;
    static Phong functions = {mirrored_direction, phong_highlight};
    return &functions;
}
