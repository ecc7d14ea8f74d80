#include "diffuse_ambient_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::lighting;
    static DiffuseAmbient functions = {direction_to_light, matt_reflection};
    return &functions;
}
