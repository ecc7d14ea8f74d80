#include "cameras_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::projections;
    static CamerasFunctions functions = {make_camera, make_orbital_camera};
    return &functions;
}
