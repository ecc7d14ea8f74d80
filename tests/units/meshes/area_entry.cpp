#include "area_table.hpp"

extern "C" const void* unit_entry()
{
    static constexpr umbral::tests::Areas areas{&umbral::meshes::triangle_area, &umbral::meshes::surface_area};
    return &areas;
}
