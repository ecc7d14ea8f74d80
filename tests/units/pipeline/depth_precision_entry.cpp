#include <umbral/pipeline/depth_precision.hpp>

#include "depth_precision_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::pipeline;
    static DepthPrecision functions = {window_depth, eye_depth, depth_resolution, fighting_distance};
    return &functions;
}
