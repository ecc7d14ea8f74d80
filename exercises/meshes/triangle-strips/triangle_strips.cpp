#include <umbral/meshes/strips.hpp>

namespace umbral::meshes {

std::vector<Strip> grid_strips(std::uint32_t columns, std::uint32_t rows)
{
    // TODO: for each row, upper and lower vertices in turn, from left to right.
    return not_implemented<std::vector<Strip>>(columns, rows);
}

std::vector<glm::uvec3> triangles_of_strip(const Strip& indices)
{
    // TODO: every three indices in a row. Turn the odd ones round; restart_index begins anew, and with an even one.
    return not_implemented<std::vector<glm::uvec3>>(indices);
}

Strip join_strips(const std::vector<Strip>& strips)
{
    // TODO: between two strips repeat the last index and the first one, so that each strip begins at an even place.
    return not_implemented<Strip>(strips);
}

std::vector<Strip> make_strips(const IndexedMesh& mesh)
{
    // TODO: begin with a triangle that has no strip yet; go on over the edge that the strip's next triangle must have,
    // as long as there is a triangle behind it that runs along the edge in the right direction and has no strip yet.
    return not_implemented<std::vector<Strip>>(mesh);
}

std::vector<std::vector<glm::vec3>> strips_of_coordinates(const std::vector<glm::vec3>& positions,
                                                          const std::vector<Strip>& strips)
{
    // TODO: the same strips, of positions.
    return not_implemented<std::vector<std::vector<glm::vec3>>>(positions, strips);
}

StripBytes strip_bytes(std::uint64_t vertices, const std::vector<Strip>& strips)
{
    // TODO: count the table of strips, and then what each way stores.
    return not_implemented<StripBytes>(vertices, strips);
}

}
