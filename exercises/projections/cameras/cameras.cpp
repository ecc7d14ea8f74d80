#include <umbral/projections/camera.hpp>

namespace umbral::projections {

// TODO: a class derived from Camera, and one derived from OrbitalCamera. What do they do alike, and where does that
// belong?

std::unique_ptr<Camera> make_camera()
{
    // TODO: return std::make_unique<YourCamera>();
    return not_implemented<std::unique_ptr<Camera>>();
}

std::unique_ptr<OrbitalCamera> make_orbital_camera(float a_degrees, float b_degrees, float distance)
{
    // TODO: a new camera, after its angles and its distance have been looked at.
    return not_implemented<std::unique_ptr<OrbitalCamera>>(a_degrees, b_degrees, distance);
}

}
