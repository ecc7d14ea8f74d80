#include "view_frame_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::projections;
    static ViewFrames functions = {view_frame, view_from};
    return &functions;
}
