#include <umbral/interaction/keyframes.hpp>

namespace umbral::interaction {

UnitQuaternion slerp_shorter(const UnitQuaternion& from, const UnitQuaternion& to, float u)
{
    // TODO: choose the sign of `to` that is nearer, and turn by a part u of the angle between both.
    return not_implemented<UnitQuaternion>(from, to, u);
}

KeyPose key_pose(std::span<const KeyFrame> frames, float seconds)
{
    // TODO: find the two frames round this time, and mix them.
    return not_implemented<KeyPose>(frames, seconds);
}

UnitQuaternion rolling_turn(const glm::vec2& way, float radius)
{
    // TODO: the angle is the way in lengths of the radius; which axis does the ball turn about?
    return not_implemented<UnitQuaternion>(way, radius);
}

std::unique_ptr<BouncingBall> make_bouncing_ball(const BallLaunch& launch)
{
    // TODO: above this function, write a class that derives from BouncingBall, and return
    // std::make_unique<YourBall>(launch).
    return not_implemented<std::unique_ptr<BouncingBall>>(launch);
}

SkeletonPlaces skeleton_places(const TwoBoneSkeleton& skeleton, const SkeletonPose& pose)
{
    // TODO: the shoulder's turn takes the elbow along; both turns, one after the other, take the hand along.
    return not_implemented<SkeletonPlaces>(skeleton, pose);
}

glm::vec3 skinned_point(const TwoBoneSkeleton& skeleton, const SkeletonPose& pose, const glm::vec3& rest,
                        float lower_weight)
{
    // TODO: take the point along with each bone, and mix both places.
    return not_implemented<glm::vec3>(skeleton, pose, rest, lower_weight);
}

}
