#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <umbral/core/not_implemented.hpp>

namespace umbral::interaction {

/// An orientation: a turn by the angle θ about a unit axis, counter-clockwise seen from its tip, as the quaternion
/// w = cos(θ/2), v = sin(θ/2) axis. Of length 1, within 3e-7; (w, v) and (-w, -v) are the same orientation.
struct UnitQuaternion {
    float w = 1;
    glm::vec3 v{0};
};

/// The orientation a part u of the way from one to another, 0 <= u <= 1: turning evenly about a fixed axis (slerp),
/// by the **shorter** way. At 0 it is `from` and at 1 it is `to`.
///
/// Never NaN: also where both are equal, nearly equal, or opposite (the same orientation). Where both ways are equally
/// long (half a turn: the product of the quaternions, of these numbers, is exactly 0), the way is that of the
/// quaternions as they are given. Guarantee of the reference, here and below: of length 1, and turned right, within
/// 3e-7; either sign. Source: K. Shoemake. Animating Rotation with Quaternion Curves. SIGGRAPH 1985.
[[nodiscard]] UnitQuaternion slerp_shorter(const UnitQuaternion& from, const UnitQuaternion& to, float u);

/// Where a thing is at one time, as an animator gave it. Course: keyframe.
struct KeyFrame {
    float seconds = 0;
    glm::vec3 position{0};
    UnitQuaternion orientation{};
};

/// Where a thing is, and how it is turned.
struct KeyPose {
    glm::vec3 position;
    UnitQuaternion orientation;
};

/// The pose in between (course: in-betweens): positions in a straight line at constant speed, orientations by
/// slerp_shorter, from each key frame to the next.
///
/// Times of frames are finite, and never fall from frame to frame. Before the first frame the pose is the first, after
/// the last it is the last, also at an infinite time. Of frames of one time the last counts from then on: a cut. Throws
/// std::invalid_argument if there are no frames, or if the time is NaN. Guarantee of the reference: positions within
/// 2e-7 of the larger end.
[[nodiscard]] KeyPose key_pose(std::span<const KeyFrame> frames, float seconds);

/// The turn of a ball that rolls without slipping on the floor y = 0, after it has come `way` along x and z: procedural
/// animation. The radius is > 0. No turn for no way.
[[nodiscard]] UnitQuaternion rolling_turn(const glm::vec2& way, float radius);

/// How a ball begins that bounces on the floor y = 0. Metres and seconds.
struct BallLaunch {
    glm::dvec3 position{0};  ///< of its lowest point; y >= 0
    glm::dvec3 velocity{0};
    double bounce = 0.8;  ///< the part of the downward speed that it keeps as upward speed, 0 to 1
};

/// A physical simulation at a **fixed step** of 5 ms, whatever the frame rate: the same path at 10, 60 and 144 frames
/// a second.
///
/// One step of h = 0.005 s: first velocity.y falls by 9.81 h, then the position grows by h velocity; if then
/// position.y < 0, position.y becomes 0 and velocity.y becomes -bounce velocity.y. Course: simulación física.
class BouncingBall {
public:
    virtual ~BouncingBall() = default;

    /// Time goes on by as many microseconds; 0 and less change nothing. As many whole steps are taken as have become
    /// due since the launch; what is left of a step is kept for the next call.
    virtual void advance(std::int64_t microseconds) = 0;

    /// The lowest point, for a picture at this time: between the state before the last step and the state after it, as
    /// far as the time that is left is a part of a step (so pictures are one step late, and smooth). Before the first
    /// step, the launch. Guarantee of the reference: within 1e-8 after a minute.
    [[nodiscard]] virtual glm::dvec3 position() const = 0;
};

/// A new ball; it shares nothing with those made before.
[[nodiscard]] std::unique_ptr<BouncingBall> make_bouncing_ball(const BallLaunch& launch);

/// Two bones, one behind the other (course: esqueleto). At rest the upper one goes from the shoulder along +x to the
/// elbow, and the lower one on along +x to the hand.
struct TwoBoneSkeleton {
    glm::vec3 shoulder{0};
    float upper_length = 1;  ///< > 0
    float lower_length = 1;  ///< > 0
};

/// How its joints are turned.
struct SkeletonPose {
    UnitQuaternion shoulder;  ///< turns all about the shoulder
    UnitQuaternion elbow;     ///< turns the lower bone about the elbow, in the axes of the upper one
};

struct SkeletonPlaces {
    glm::vec3 elbow;
    glm::vec3 hand;
};

/// Where elbow and hand are in a pose: forward kinematics. Guarantee of the reference, here and below: within 2e-7 of
/// the distance from the shoulder and of the shoulder's own.
[[nodiscard]] SkeletonPlaces skeleton_places(const TwoBoneSkeleton& skeleton, const SkeletonPose& pose);

/// Where a point of the skin goes that is at `rest` when the skeleton is at rest: the mixture (1 - lower_weight) of
/// where the upper bone takes it and lower_weight of where the lower bone takes it (linear blend skinning).
/// 0 <= lower_weight <= 1.
[[nodiscard]] glm::vec3 skinned_point(const TwoBoneSkeleton& skeleton, const SkeletonPose& pose, const glm::vec3& rest,
                                      float lower_weight);

}
