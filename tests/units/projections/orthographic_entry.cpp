#include "orthographic_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::projections;
    static Orthographic functions = {orthographic_matrix, inverse_orthographic_matrix};
    return &functions;
}
