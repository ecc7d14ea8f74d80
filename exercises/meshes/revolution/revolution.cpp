#include <umbral/meshes/revolution.hpp>

namespace umbral::meshes {

TexturedMesh revolve(std::span<const glm::vec2> profile, std::uint32_t copies)
{
    // TODO: the vertices, copy by copy: copy i is the profile turned by 2π i / (copies - 1), and the last one lies
    // exactly where the first one does. With each vertex its normal (from the stretches of the profile before and after
    // it) and its (s, t). Then the triangles between each copy and the next, but for those that have no area.
    return not_implemented<TexturedMesh>(profile, copies);
}

}
