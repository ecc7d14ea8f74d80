#include <umbral/interaction/three_mode_camera.hpp>

namespace umbral::interaction {

std::unique_ptr<ThreeModeCamera> make_three_mode_camera(const ThreeModeSettings& settings)
{
    // TODO: above this function, write a class that derives from ThreeModeCamera and overrides all of its functions.
    // Keep in it the mode, the attention point and its spherical coordinates (azimuth, elevation, distance); axes,
    // observer and matrix follow from these. Then return std::make_unique<YourCamera>(settings).
    return not_implemented<std::unique_ptr<ThreeModeCamera>>(settings);
}

}
