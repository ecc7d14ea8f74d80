#include "fit_frustum_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::projections;
    static Fit functions = {fit_cube, fit_sphere, fit_cube_to_fovy};
    return &functions;
}
