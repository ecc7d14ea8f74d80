#include <umbral/interaction/camera_animation.hpp>

namespace umbral::interaction {

FlightPose flight_pose(const CameraFlight& flight, float seconds)
{
    // TODO: refuse what is no time or duration, find which part of the flight is over (0 to 1), and mix both ends of
    // each line with it.
    return not_implemented<FlightPose>(flight, seconds);
}

glm::mat4 flight_view(const CameraFlight& flight, float seconds)
{
    // TODO: the view matrix of the camera that stands and looks as above, with the world's y axis up. You may call
    // projections::view_matrix from <umbral/projections/view.hpp>, or write it.
    return not_implemented<glm::mat4>(flight, seconds);
}

}
