#include <umbral/projections/oblique.hpp>

namespace umbral::projections {

float foreshortening_of(float alpha_degrees)
{
    // TODO: a ray that meets the view plane under that angle, one unit deep: how far aside does it arrive?
    return not_implemented<float>(alpha_degrees);
}

glm::mat4 oblique_shear(const Lean& lean)
{
    // TODO: x and y each get a multiple of z. Which sign, if the camera looks along -z?
    return not_implemented<glm::mat4>(lean);
}

glm::mat4 oblique_matrix(const ViewVolume& box, const Lean& lean)
{
    // TODO: the shear, then the orthographic matrix of the box.
    return not_implemented<glm::mat4>(box, lean);
}

glm::vec3 projector_direction(const Lean& lean)
{
    // TODO: which direction does the shear take to that of -z?
    return not_implemented<glm::vec3>(lean);
}

}
