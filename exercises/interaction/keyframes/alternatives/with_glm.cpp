// alternative: GLM's quaternions in double; the turn between both as an axis and an angle, of which a part is taken
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <umbral/interaction/keyframes.hpp>

namespace umbral::interaction {
namespace {

glm::dquat wide(const UnitQuaternion& q) { return glm::normalize(glm::dquat(q.w, q.v.x, q.v.y, q.v.z)); }
UnitQuaternion narrow(const glm::dquat& q) { return {static_cast<float>(q.w), glm::vec3(q.x, q.y, q.z)}; }

struct Ball : BouncingBall {
    explicit Ball(const BallLaunch& l) : launch(l), old(l.position) {}

    void advance(std::int64_t microseconds) override
    {
        if (microseconds > 0) total += microseconds;
        for (; done < total / 5000; ++done) {
            old = launch.position;
            launch.velocity += 0.005 * glm::dvec3(0, -9.81, 0);
            launch.position += 0.005 * launch.velocity;
            if (launch.position.y >= 0) continue;
            launch.position.y = 0;
            launch.velocity.y = -launch.bounce * launch.velocity.y;
        }
    }
    glm::dvec3 position() const override
    {
        return old + (launch.position - old) * (static_cast<double>(total % 5000) / 5000.0);
    }

    BallLaunch launch;
    glm::dvec3 old;
    std::int64_t total = 0;
    std::int64_t done = 0;
};

}

UnitQuaternion slerp_shorter(const UnitQuaternion& from, const UnitQuaternion& to, float u)
{
    const glm::dquat p = wide(from);
    glm::dquat turn = wide(to) * glm::conjugate(p);
    if (turn.w < 0) turn = -turn;
    const glm::dvec3 axis(turn.x, turn.y, turn.z);
    const double sine = glm::length(axis);
    if (sine < 1e-12) return narrow(p);
    return narrow(glm::angleAxis(2 * u * std::atan2(sine, turn.w), axis / sine) * p);
}

KeyPose key_pose(std::span<const KeyFrame> frames, float seconds)
{
    if (frames.empty() || std::isnan(seconds)) throw std::invalid_argument("no frames, or no time");
    std::size_t i = frames.size();
    while (i > 0 && frames[i - 1].seconds > seconds) --i;
    if (i == 0) return {frames[0].position, frames[0].orientation};
    const KeyFrame& a = frames[i - 1];
    if (i == frames.size()) return {a.position, a.orientation};
    const KeyFrame& b = frames[i];
    const float u = (seconds - a.seconds) / (b.seconds - a.seconds);
    return {glm::mix(a.position, b.position, u), slerp_shorter(a.orientation, b.orientation, u)};
}

UnitQuaternion rolling_turn(const glm::vec2& way, float radius)
{
    const glm::dvec3 along(way.x, 0, way.y);
    const glm::dvec3 axis = glm::cross(glm::dvec3(0, 1, 0), along);
    if (axis == glm::dvec3(0)) return {1, {0, 0, 0}};
    return narrow(glm::angleAxis(glm::length(along) / radius, glm::normalize(axis)));
}

std::unique_ptr<BouncingBall> make_bouncing_ball(const BallLaunch& launch) { return std::make_unique<Ball>(launch); }

SkeletonPlaces skeleton_places(const TwoBoneSkeleton& skeleton, const SkeletonPose& pose)
{
    const glm::dvec3 elbow =
        glm::dvec3(skeleton.shoulder) + wide(pose.shoulder) * glm::dvec3(skeleton.upper_length, 0, 0);
    const glm::dvec3 hand = elbow + wide(pose.shoulder) * wide(pose.elbow) * glm::dvec3(skeleton.lower_length, 0, 0);
    return {glm::vec3(elbow), glm::vec3(hand)};
}

glm::vec3 skinned_point(const TwoBoneSkeleton& skeleton, const SkeletonPose& pose, const glm::vec3& rest,
                        float lower_weight)
{
    const glm::dvec3 shoulder(skeleton.shoulder);
    const glm::dvec3 elbow_at_rest = shoulder + glm::dvec3(skeleton.upper_length, 0, 0);
    const glm::dvec3 elbow(skeleton_places(skeleton, pose).elbow);
    const glm::dvec3 with_upper = shoulder + wide(pose.shoulder) * (glm::dvec3(rest) - shoulder);
    const glm::dvec3 with_lower = elbow + wide(pose.shoulder) * wide(pose.elbow) * (glm::dvec3(rest) - elbow_at_rest);
    return glm::vec3((1.0 - lower_weight) * with_upper + double(lower_weight) * with_lower);
}

}
