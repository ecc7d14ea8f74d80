#include "cylinder_cone_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::raytracing;
    static CylinderConeFunctions functions = {unit_cylinder_field, unit_cone_field, intersect_unit_cylinder,
                                              intersect_unit_cone};
    return &functions;
}
