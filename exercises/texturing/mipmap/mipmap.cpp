#include <umbral/texturing/mipmap.hpp>

namespace umbral::texturing {

Mipmap build_mipmap(const Grid<glm::vec4>& texture)
{
    // TODO: 1. refuse what cannot be halved again and again
    //       2. level 0 is the texture; each next texel is a mean of four; until one is left
    return not_implemented<Mipmap>(texture);
}

float level_at_distance(float distance, float near)
{
    // TODO: one level more with each doubling of the distance.
    return not_implemented<float>(distance, near);
}

float level_of_step(glm::vec2 by_x, glm::vec2 by_y, glm::ivec2 size)
{
    // TODO: how many texels lie between this pixel and the next one, in both directions?
    return not_implemented<float>(by_x, by_y, size);
}

glm::vec4 trilinear(const Mipmap& mipmap, glm::vec2 uv, float level)
{
    // TODO: 1. between which two levels does it lie?
    //       2. look up in both (lookup.hpp), and blend
    return not_implemented<glm::vec4>(mipmap, uv, level);
}

}
