// Based on: K. Shoemake. Animating Rotation with Quaternion Curves. SIGGRAPH 1985 (slerp); G. Fiedler. Fix Your
// Timestep! 2004 (the step, and pictures between two of them); the course's section on animation.

#include <umbral/interaction/keyframes.hpp>

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <cmath>
#include <stdexcept>

namespace umbral::interaction {
namespace {

/// A quaternion in double, as (v, w).
using Quaternion = glm::dvec4;

/// Below this angle sine and angle are the same in double, and their quotient must not be taken.
constexpr double no_angle = 1e-8;

constexpr double gravity = 9.81;
constexpr std::int64_t step_microseconds = 5000;
constexpr double step_seconds = 0.005;

Quaternion unit(const UnitQuaternion& q) { return normalize(Quaternion(glm::dvec3(q.v), q.w)); }

UnitQuaternion rounded(const Quaternion& q) { return {static_cast<float>(q.w), glm::vec3(q)}; }

glm::dvec3 rotated(const UnitQuaternion& turn, const glm::dvec3& point)
{
    const Quaternion q = unit(turn);
    const glm::dvec3 v(q);
    const glm::dvec3 twice = 2.0 * cross(v, point);
    return point + q.w * twice + cross(v, twice);
}

class ReferenceBall final : public BouncingBall {
public:
    explicit ReferenceBall(const BallLaunch& launch)
        : bounce_(launch.bounce), before_(launch.position), now_(launch.position), velocity_(launch.velocity)
    {
    }

    void advance(std::int64_t microseconds) override
    {
        if (microseconds <= 0) return;
        for (left_ += microseconds; left_ >= step_microseconds; left_ -= step_microseconds) step();
    }

    [[nodiscard]] glm::dvec3 position() const override
    {
        return mix(before_, now_, static_cast<double>(left_) / static_cast<double>(step_microseconds));
    }

private:
    void step()
    {
        before_ = now_;
        velocity_.y -= gravity * step_seconds;
        now_ += step_seconds * velocity_;
        if (now_.y < 0) {
            now_.y = 0;
            velocity_.y *= -bounce_;
        }
    }

    double bounce_;
    glm::dvec3 before_;
    glm::dvec3 now_;
    glm::dvec3 velocity_;
    std::int64_t left_ = 0;  ///< of a step, in whole microseconds: no frame rate loses any
};

}

UnitQuaternion slerp_shorter(const UnitQuaternion& from, const UnitQuaternion& to, float u)
{
    const glm::dquat p(from.w, glm::dvec3(from.v));
    glm::dquat q(to.w, glm::dvec3(to.v));
    if (glm::dot(p, q) < 0) q = -q;
    const glm::dquat m = glm::normalize(glm::mix(p, q, double(u)));
    return {float(m.w), glm::vec3(m.x, m.y, m.z)};
}

KeyPose key_pose(std::span<const KeyFrame> frames, float seconds)
{
    if (frames.empty()) throw std::invalid_argument("an animation needs a key frame");
    if (std::isnan(seconds)) throw std::invalid_argument("a time must be a number");
    // The first frame that is still to come.
    const auto next = std::upper_bound(frames.begin(), frames.end(), seconds,
                                       [](float time, const KeyFrame& frame) { return time < frame.seconds; });
    if (next == frames.begin()) return {frames.front().position, frames.front().orientation};
    const KeyFrame& last = *(next - 1);
    if (next == frames.end()) return {last.position, last.orientation};
    const double u = (double{seconds} - last.seconds) / (double{next->seconds} - last.seconds);
    return {glm::vec3(mix(glm::dvec3(last.position), glm::dvec3(next->position), u)),
            slerp_shorter(last.orientation, next->orientation, static_cast<float>(u))};
}

UnitQuaternion rolling_turn(const glm::vec2& way, float radius)
{
    const double distance = length(glm::dvec2(way));
    if (distance == 0) return {};
    const double half_angle = distance / radius / 2;
    // The upward axis times the way: a ball that goes to +x turns clockwise about z.
    const glm::dvec3 axis(way.y / distance, 0, -way.x / distance);
    return rounded(Quaternion(std::sin(half_angle) * axis, std::cos(half_angle)));
}

std::unique_ptr<BouncingBall> make_bouncing_ball(const BallLaunch& launch)
{
    return std::make_unique<ReferenceBall>(launch);
}

SkeletonPlaces skeleton_places(const TwoBoneSkeleton& skeleton, const SkeletonPose& pose)
{
    const glm::vec3 elbow = skeleton.shoulder + glm::vec3(skeleton.upper_length, 0, 0);
    const glm::vec3 hand = elbow + glm::vec3(skeleton.lower_length, 0, 0);
    return {skinned_point(skeleton, pose, elbow, 0), skinned_point(skeleton, pose, hand, 1)};
}

glm::vec3 skinned_point(const TwoBoneSkeleton& skeleton, const SkeletonPose& pose, const glm::vec3& rest,
                        float lower_weight)
{
    const glm::dvec3 shoulder(skeleton.shoulder);
    const glm::dvec3 upper(skeleton.upper_length, 0, 0);
    const glm::dvec3 at = glm::dvec3(rest) - shoulder;
    // The elbow turns first, about its place at rest, and the shoulder takes everything along.
    const glm::dvec3 bent = upper + rotated(pose.elbow, at - upper);
    return glm::vec3(shoulder + rotated(pose.shoulder, mix(at, bent, double{lower_weight})));
}

}
