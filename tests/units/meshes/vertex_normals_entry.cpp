#include "vertex_normals_table.hpp"

extern "C" const void* unit_entry()
{
    static constexpr umbral::tests::Normals normals{&umbral::meshes::face_normals, &umbral::meshes::vertex_normals};
    return &normals;
}
