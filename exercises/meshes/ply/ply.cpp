#include <umbral/meshes/ply.hpp>
#include <umbral/meshes/ply_types.hpp>

namespace umbral::meshes {

PolygonMesh read_ply(std::span<const std::byte> file)
{
    // TODO: read the header line by line into a list of elements, each with its properties; refuse what cannot be
    // understood. Then read the elements in their order: keep x, y, z of `vertex` and the corners of `face`, and step
    // over everything else. throw PlyError(PlyProblem::…, place, "what was expected, and what came") where the file is
    // at fault.
    return not_implemented<PolygonMesh>(file);
}

std::string write_ply(const PolygonMesh& mesh, PlyFormat format)
{
    // TODO: the header, one row a vertex, one row a face. std::to_chars gives the shortest decimal that reads back as
    // the same float.
    return not_implemented<std::string>(mesh, format);
}

}
