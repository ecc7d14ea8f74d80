#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <umbral/core/not_implemented.hpp>

namespace umbral::interaction {

/// Where an orbit camera begins, and how far it may go. Angles in radians.
struct OrbitCameraSettings {
    glm::dvec3 target{0};       ///< what it looks at: always in the middle of the picture
    double distance = 5;        ///< from the target; min_distance <= distance <= max_distance
    double yaw = 0;             ///< round the world's y axis: 0 stands on the side of +z, π/2 on that of +x
    double pitch = 0;           ///< above the plane y = target.y; |pitch| <= max_pitch
    double min_distance = 0.1;  ///< > 0
    double max_distance = 1000;
    double max_pitch = 1.5533430342749532;  ///< 89 degrees; less than π/2, where the picture would have no up
    int viewport_height = 480;              ///< pixels, > 0
};

/// A camera that turns round a point: modo orbital, or examinar.
///
/// It stands at target + distance (cos pitch sin yaw, sin pitch, cos pitch cos yaw) and looks at the target, with the
/// world's y axis up in the picture. **The scene follows the hand**: a drag to the right turns the front of the scene
/// to the right, so the camera goes left, and its yaw falls; a drag up turns it up, so the camera goes down, and its
/// pitch falls. Events with NaN or infinity are ignored as a whole. Course: modo orbital o examinar,
/// CamaraOrbitalSimple.
class OrbitCamera {
public:
    virtual ~OrbitCamera() = default;

    /// The pointer went `right` and `up` pixels with the button down. As many pixels as the viewport is high turn by π,
    /// in both directions. Pitch stops at ±max_pitch: what a drag would turn farther is lost, so that the way back
    /// begins at once.
    virtual void drag(double right, double up) = 0;

    /// The wheel turned by `steps`, or parts of a step; > 0: nearer. Each divides the distance by 1.1; it stops at its
    /// limits.
    virtual void scroll(double steps) = 0;

    /// The viewport has another size in pixels. Sizes that are not positive, as of a minimised window, are ignored.
    virtual void resize(int width, int height) = 0;

    /// Back to where it began; the viewport stays.
    virtual void reset() = 0;

    /// The matrix that takes the world to camera coordinates (the camera at the origin, looking along -z), at any
    /// moment. Guarantee of the reference, for |target| up to 1e6 and after a million turns in 200,000 drags: rotation
    /// within 1e-7 in every entry, and translation within 1e-7 of |target| + distance.
    [[nodiscard]] virtual glm::mat4 view() const = 0;
};

/// A new camera, as its settings say; it shares nothing with those made before, and outlives its settings.
[[nodiscard]] std::unique_ptr<OrbitCamera> make_orbit_camera(const OrbitCameraSettings& settings);

}
