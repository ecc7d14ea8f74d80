// alternative: turns in the plane of both quaternions, by the part of the second that is perpendicular to the first; in
// long double, with a class of its own for orientations
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <umbral/interaction/keyframes.hpp>

namespace umbral::interaction {
namespace {

using Long = long double;

struct Turn {
    Long w, x, y, z;

    explicit Turn(const UnitQuaternion& q) : w(q.w), x(q.v.x), y(q.v.y), z(q.v.z) { *this = *this * (1 / length()); }
    Turn(Long w_, Long x_, Long y_, Long z_) : w(w_), x(x_), y(y_), z(z_) {}
    Turn operator*(Long s) const { return {w * s, x * s, y * s, z * s}; }
    Turn operator+(const Turn& o) const { return {w + o.w, x + o.x, y + o.y, z + o.z}; }
    Turn operator*(const Turn& o) const
    {
        return {w * o.w - x * o.x - y * o.y - z * o.z, w * o.x + x * o.w + y * o.z - z * o.y,
                w * o.y - x * o.z + y * o.w + z * o.x, w * o.z + x * o.y - y * o.x + z * o.w};
    }
    Long dot(const Turn& o) const { return w * o.w + x * o.x + y * o.y + z * o.z; }
    Long length() const { return std::sqrt(dot(*this)); }
    Turn back() const { return {w, -x, -y, -z}; }
    glm::dvec3 operator()(const glm::dvec3& p) const
    {
        const Turn t = *this * Turn(0, p.x, p.y, p.z) * back();
        return {double(t.x), double(t.y), double(t.z)};
    }
    UnitQuaternion rounded() const { return {float(w), {float(x), float(y), float(z)}}; }
};

class Bouncer : public BouncingBall {
public:
    explicit Bouncer(const BallLaunch& launch) : states_{launch, launch} {}
    void advance(std::int64_t microseconds) override
    {
        microseconds = std::max<std::int64_t>(microseconds, 0);
        const std::int64_t due = (rest_ + microseconds) / 5000;
        rest_ = (rest_ + microseconds) % 5000;
        for (std::int64_t i = 0; i < due; ++i) {
            states_[0] = states_[1];
            BallLaunch& s = states_[1];
            s.velocity.y -= 0.04905;
            s.position += s.velocity / 200.0;
            if (s.position.y < 0) {
                s.velocity.y *= -s.bounce;
                s.position.y = 0;
            }
        }
    }
    glm::dvec3 position() const override
    {
        return states_[0].position + double(rest_) * 2e-4 * (states_[1].position - states_[0].position);
    }

private:
    BallLaunch states_[2];
    std::int64_t rest_ = 0;
};

}

UnitQuaternion slerp_shorter(const UnitQuaternion& from, const UnitQuaternion& to, float u)
{
    const Turn p(from);
    Turn q(to);
    if (p.dot(q) < 0) q = q * -1;
    const Turn aside = q + p * -p.dot(q);
    const Long sine = aside.length();
    if (sine == 0) return from;
    const Long angle = u * std::atan2(sine, p.dot(q));
    return (p * std::cos(angle) + aside * (std::sin(angle) / sine)).rounded();
}

KeyPose key_pose(std::span<const KeyFrame> frames, float seconds)
{
    if (frames.size() == 0 || seconds != seconds) throw std::invalid_argument("nothing to interpolate");
    const auto late =
        std::find_if(frames.begin(), frames.end(), [&](const KeyFrame& f) { return f.seconds > seconds; });
    const KeyFrame& a = late == frames.begin() ? *late : *std::prev(late);
    const KeyFrame& b = late == frames.end() ? frames.back() : *late;
    const double span = double(b.seconds) - double(a.seconds);
    const double u = span > 0 ? std::clamp((double(seconds) - double(a.seconds)) / span, 0.0, 1.0) : 0.0;
    const glm::dvec3 p(a.position);
    return {glm::vec3(p + u * (glm::dvec3(b.position) - p)), slerp_shorter(a.orientation, b.orientation, float(u))};
}

UnitQuaternion rolling_turn(const glm::vec2& way, float radius)
{
    // First along x, then turned into the direction of the way.
    const double direction = std::atan2(-double(way.y), double(way.x));
    const double angle = std::hypot(double(way.x), double(way.y)) / radius;
    const Turn aim(std::cos(direction / 2), 0, std::sin(direction / 2), 0);
    const Turn roll(std::cos(angle / 2), 0, 0, -std::sin(angle / 2));
    return (aim * roll * aim.back()).rounded();
}

std::unique_ptr<BouncingBall> make_bouncing_ball(const BallLaunch& launch) { return std::make_unique<Bouncer>(launch); }

SkeletonPlaces skeleton_places(const TwoBoneSkeleton& skeleton, const SkeletonPose& pose)
{
    const Turn first(pose.shoulder);
    const glm::dvec3 elbow = glm::dvec3(skeleton.shoulder) + first({skeleton.upper_length, 0, 0});
    return {glm::vec3(elbow), glm::vec3(elbow + (first * Turn(pose.elbow))({skeleton.lower_length, 0, 0}))};
}

glm::vec3 skinned_point(const TwoBoneSkeleton& skeleton, const SkeletonPose& pose, const glm::vec3& rest,
                        float lower_weight)
{
    const Turn first(pose.shoulder);
    glm::dvec3 p = glm::dvec3(rest) - glm::dvec3(skeleton.shoulder);
    const glm::dvec3 one = first(p);
    p.x -= skeleton.upper_length;
    const glm::dvec3 other = first({skeleton.upper_length, 0, 0}) + (first * Turn(pose.elbow))(p);
    return glm::vec3(glm::dvec3(skeleton.shoulder) + one + double(lower_weight) * (other - one));
}

}
