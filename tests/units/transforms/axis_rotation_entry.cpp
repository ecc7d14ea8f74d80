#include "axis_rotation_table.hpp"

extern "C" const void* unit_entry()
{
    using namespace umbral::transforms;
    static constexpr umbral::tests::Rotations rotations{&rotate_vector, &rotation_matrix, &compose_rotations};
    return &rotations;
}
