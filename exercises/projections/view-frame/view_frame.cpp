#include <umbral/projections/view_frame.hpp>

namespace umbral::projections {

std::optional<ViewFrame> view_frame(const ViewParameters& view)
{
    // TODO: z along the normal, x perpendicular to up and z, y to both. When is there no such frame?
    return not_implemented<std::optional<ViewFrame>>(view);
}

ViewParameters view_from(const glm::vec3& target, float distance, float azimuth_degrees, float elevation_degrees,
                         float roll_degrees)
{
    // TODO: the vector to the eye from the two angles, then what points up in the picture, which the roll turns.
    return not_implemented<ViewParameters>(target, distance, azimuth_degrees, elevation_degrees, roll_degrees);
}

}
