#pragma once

#include <memory>
#include <umbral/transforms/pipeline.hpp>

namespace umbral::transforms {

/// The measures of the android at rest, y up, its face towards +z, so that its left arm is at x > 0. It stands on y =
/// -1.4.
namespace android_measures {
inline constexpr float body_height = 2;     ///< a cylinder of radius 1 on y = 0
inline constexpr float head_height = 2.1F;  ///< the centre of the head, a half sphere of radius 1, on the axis y
inline constexpr glm::vec3 eye{0.35F, 0.5F,
                               0.75F};  ///< centre of the left eye, seen from the head's centre; the right one at -x
inline constexpr float eye_radius = 0.1F;
inline constexpr glm::vec3 antenna{0.4F, 0.8F,
                                   0};  ///< foot of the left antenna, seen from the head's centre; the right one at -x
inline constexpr float antenna_radius = 0.05F;
inline constexpr float antenna_length = 0.5F;
inline constexpr float antenna_tilt = 0.5235987755982988F;  ///< 30 degrees, outwards: about the axis z
inline constexpr float limb_radius = 0.35F;
inline constexpr float limb_length = 1.05F;  ///< between the centres of a limb's two half spheres
inline constexpr glm::vec3 shoulder{1.45F, 1.55F,
                                    0};      ///< centre of the left arm's upper half sphere; the right one at -x
inline constexpr glm::vec3 hip{0.5F, 0, 0};  ///< of the left leg's; the right one at -x
}

/// An android of half spheres and cylinders, whose arms and head turn.
///
/// Three angles in radians, counter-clockwise seen from the tip of the axis (right-hand rule): the arms turn about the
/// axis x through the centres of their upper half spheres, so that a negative angle lifts an arm to the front; the
/// head, with eyes and antennae, about the axis y. A setter *sets*: it does not add. An angle that is not finite is
/// ignored. At first all angles are 0: the android at rest. Course: problem 2.25, AndroidParam.
class Android {
public:
    virtual ~Android() = default;

    virtual void set_left_arm(double angle) = 0;
    virtual void set_right_arm(double angle) = 0;
    virtual void set_head(double angle) = 0;

    /// Draws 18 solids in the current colour, but the eyes in white; neutral. In this order: body; head, left eye,
    /// right eye, left antenna, right antenna; left arm, right arm, left leg, right leg, each of them upper half
    /// sphere, cylinder, lower half sphere.
    ///
    /// Limbs hang downwards: the upper half sphere is the upper half of its sphere, the lower one the lower half. An
    /// eye's half sphere has its dome towards +z. Guarantee of the reference: every place is computed from the angles
    /// anew, so nothing drifts, however often they were set.
    virtual void draw(Pipeline& pipeline) const = 0;
};

/// An android at rest; it shares nothing with those made before. Course: problem 2.24, Android.
[[nodiscard]] std::unique_ptr<Android> make_android();

}
