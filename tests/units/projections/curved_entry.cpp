#include "curved_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::projections;
    static CurvedFunctions functions = {spherical_projection, cylindrical_projection, visual_angle, tessellated,
                                        without_seam};
    return &functions;
}
