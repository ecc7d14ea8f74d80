#include <umbral/texturing/lookup.hpp>

namespace umbral::texturing {

glm::vec4 lookup(const Grid<glm::vec4>& texture, const Sampler& sampler, glm::vec2 uv)
{
    // TODO: bring u and v into [0, 1] as sampler.wrap_u and wrap_v say, and multiply them by the number of columns and
    // rows. Filter::nearest: the texel that owns the place. Filter::bilinear: a blend of the four texels whose centres
    // lie round it. v goes up, but row 0 is the top one.
    return not_implemented<glm::vec4>(texture, sampler, uv);
}

}
