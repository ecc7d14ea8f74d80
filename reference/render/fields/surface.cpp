#include "render/fields/isosurface.hpp"
#include "render/sheet.hpp"
#include "scene/sphere_uvs.hpp"

namespace umbral::render {

Surface make_solid(const scene::DistanceField& field)
{
    meshes::IndexedMesh mesh = fields::isosurface(fields::field_of(field.field), field.cells);
    scene::SphereUvs map = scene::sphere_uvs(mesh.positions, mesh.triangles);
    return {std::move(mesh), std::move(map.uvs), std::move(map.triangles)};
}

}
