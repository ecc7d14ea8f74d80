#include <umbral/projections/fit.hpp>

namespace umbral::projections {

ViewVolume fit_cube(float side, float distance, const PictureSize& picture)
{
    // TODO: which of the cube's faces decides how large the window at the near plane must be? Then make the longer side
    // of the picture fit its shape.
    return not_implemented<ViewVolume>(side, distance, picture);
}

ViewVolume fit_sphere(float radius, float distance, const PictureSize& picture)
{
    // TODO: the side planes touch the sphere. Draw the right-angled triangle of eye, middle and point of contact.
    return not_implemented<ViewVolume>(radius, distance, picture);
}

PlacedVolume fit_cube_to_fovy(const glm::vec3& centre, float side, float fovy_degrees, const PictureSize& picture)
{
    // TODO: the window is that of fit_cube; how far before it does the eye see it under that angle?
    return not_implemented<PlacedVolume>(centre, side, fovy_degrees, picture);
}

}
