#include "reflect_refract_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::raytracing;
    static ReflectRefractFunctions functions = {mirrored_direction, refracted_direction, critical_angle};
    return &functions;
}
