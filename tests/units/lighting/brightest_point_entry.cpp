#include "brightest_point_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::lighting;
    static BrightestPoint functions = {brightest_diffuse, is_seen, brightest_seen, brightest_specular};
    return &functions;
}
