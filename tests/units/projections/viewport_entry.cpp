#include "viewport_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::projections;
    static ViewportFunctions functions = {viewport_matrix, ndc_from_window, pixel_at, pixel_centre};
    return &functions;
}
