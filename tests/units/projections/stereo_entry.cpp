#include "stereo_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::projections;
    static StereoFunctions functions = {off_axis_pair,        toe_in_pair, parallax,
                                        distance_of_parallax, disparity,   anaglyph};
    return &functions;
}
