#include "field_of_view_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::projections;
    static FieldOfView functions = {perspective_matrix, reversed_perspective_matrix, vertical_field_of_view};
    return &functions;
}
