#include "camera_rays_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::raytracing;
    static CameraRaysFunctions functions = {primary_ray, pixel_samples, render_picture};
    return &functions;
}
