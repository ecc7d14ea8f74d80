#include "oblique_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::projections;
    static ObliqueFunctions functions = {foreshortening_of, oblique_shear, oblique_matrix, projector_direction};
    return &functions;
}
