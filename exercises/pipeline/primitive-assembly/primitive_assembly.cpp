#include <umbral/pipeline/assembly.hpp>

namespace umbral::pipeline {

std::vector<Primitive> assemble(PrimitiveType type, std::span<const std::uint32_t> vertices)
{
    // TODO: ten types of primitive, a loop each. Every other triangle of a strip swaps its first two corners.
    return not_implemented<std::vector<Primitive>>(type, vertices);
}

bool is_front_facing(std::span<const glm::vec2> corners)
{
    // TODO: the signed area of the face, positive if its corners go round counter-clockwise (y is up).
    return not_implemented<bool>(corners);
}

DrawList draw_list(PrimitiveType type, std::span<const std::uint32_t> vertices, std::span<const glm::vec2> window,
                   Culling culling, PolygonMode mode)
{
    // TODO: assemble; pass points and segments on; leave out faces by culling; turn the rest into points, segments or
    // triangles.
    return not_implemented<DrawList>(type, vertices, window, culling, mode);
}

}
