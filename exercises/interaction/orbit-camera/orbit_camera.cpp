#include <umbral/interaction/orbit_camera.hpp>

namespace umbral::interaction {

std::unique_ptr<OrbitCamera> make_orbit_camera(const OrbitCameraSettings& settings)
{
    // TODO: above this function, write a class that derives from OrbitCamera and overrides drag, scroll, resize, reset
    // and view. Keep in it what changes (yaw, pitch, distance, the viewport's height), and compute the matrix from that
    // in view(). Then return std::make_unique<YourCamera>(settings).
    return not_implemented<std::unique_ptr<OrbitCamera>>(settings);
}

}
