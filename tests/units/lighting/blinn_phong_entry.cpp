#include "blinn_phong_functions.hpp"

extern "C" void* unit_entry()
{
    using namespace umbral::lighting;
    static BlinnPhong functions = {half_vector, blinn_highlight};
    return &functions;
}
