#include <umbral/texturing/bump.hpp>

namespace umbral::texturing {

glm::vec2 slopes(const Grid<glm::vec4>& heights, glm::vec2 uv, float k)
{
    // TODO: four lookups round the place (lookup.hpp), one texel away on each side.
    return not_implemented<glm::vec2>(heights, uv, k);
}

Tangents triangle_tangents(const std::array<glm::vec3, 3>& positions, const std::array<glm::vec2, 3>& coordinates)
{
    // TODO: two edges of the triangle, in space and in the texture, are two equations for two unknown vectors.
    return not_implemented<Tangents>(positions, coordinates);
}

glm::vec3 bumped_normal(const glm::vec3& n, const Tangents& tangents, glm::vec2 slopes)
{
    // TODO: 1. tilt both tangents along the normal
    //       2. their cross product, on the side of n, with length 1
    return not_implemented<glm::vec3>(n, tangents, slopes);
}

}
