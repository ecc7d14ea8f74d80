#include "frustum_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::projections;
    static Frustum functions = {frustum_matrix, frustum_factors, project_point};
    return &functions;
}
