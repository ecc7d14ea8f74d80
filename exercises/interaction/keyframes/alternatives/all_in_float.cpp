// alternative: the textbook's forms, mostly in float: the arc cosine of the product, an even mixture for small angles,
// seconds that are added up in double, and matrices for the bones
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>
#include <umbral/interaction/keyframes.hpp>

namespace umbral::interaction {
namespace {

class Simulation : public BouncingBall {
public:
    explicit Simulation(const BallLaunch& launch) : launch_(launch), p_(launch.position), last_(p_), v_(launch.velocity)
    {
    }
    void advance(std::int64_t microseconds) override
    {
        if (microseconds < 0) return;
        accumulator_ += 1e-6 * static_cast<double>(microseconds);
        while (accumulator_ >= h) {
            accumulator_ -= h;
            last_ = p_;
            v_[1] = v_[1] - 9.81 * h;
            p_ = p_ + v_ * h;
            if (p_[1] < 0.0) {
                p_[1] = 0.0;
                v_[1] = -v_[1] * launch_.bounce;
            }
        }
    }
    glm::dvec3 position() const override
    {
        const double alpha = accumulator_ / h;
        return last_ * (1 - alpha) + p_ * alpha;
    }

private:
    static constexpr double h = 1.0 / 200;
    BallLaunch launch_;
    glm::dvec3 p_, last_, v_;
    double accumulator_ = 0;
};

glm::mat4 matrix(const UnitQuaternion& q)
{
    const float x = q.v.x, y = q.v.y, z = q.v.z, w = q.w;
    return glm::mat4(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0,  //
                     2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0,  //
                     2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), 0,  //
                     0, 0, 0, 1);
}

// The places of both bones as matrices from where they are at rest.
struct Bones {
    glm::mat4 upper;
    glm::mat4 lower;
};

Bones bones(const TwoBoneSkeleton& s, const SkeletonPose& pose)
{
    const glm::mat4 id(1.0F);
    const glm::vec3 length(s.upper_length, 0, 0);
    const glm::mat4 upper = glm::translate(id, s.shoulder) * matrix(pose.shoulder);
    const glm::mat4 lower = upper * glm::translate(id, length) * matrix(pose.elbow) * glm::translate(id, -length);
    const glm::mat4 rest = glm::translate(id, -s.shoulder);
    return {upper * rest, lower * rest};
}

}

UnitQuaternion slerp_shorter(const UnitQuaternion& from, const UnitQuaternion& to, float u)
{
    float product = from.w * to.w + glm::dot(from.v, to.v);
    const float sign = product < 0 ? -1.0F : 1.0F;
    product *= sign;
    float a = 1 - u;
    float b = u;
    if (product < 0.9999F) {
        const float angle = std::acos(product);
        a = std::sin((1 - u) * angle) / std::sin(angle);
        b = std::sin(u * angle) / std::sin(angle);
    }
    b *= sign;
    const glm::vec4 mixed(a * from.v + b * to.v, a * from.w + b * to.w);
    const glm::vec4 unit = mixed / glm::length(mixed);
    return {unit.w, glm::vec3(unit)};
}

KeyPose key_pose(std::span<const KeyFrame> frames, float seconds)
{
    if (frames.empty()) throw std::invalid_argument("key_pose: no frames");
    if (!(seconds == seconds)) throw std::invalid_argument("key_pose: time is not a number");
    KeyPose pose{frames[0].position, frames[0].orientation};
    for (std::size_t i = 0; i < frames.size() && frames[i].seconds <= seconds; ++i) {
        pose = {frames[i].position, frames[i].orientation};
        if (i + 1 == frames.size() || frames[i + 1].seconds <= seconds) continue;
        const float u = (seconds - frames[i].seconds) / (frames[i + 1].seconds - frames[i].seconds);
        pose.position = (1 - u) * frames[i].position + u * frames[i + 1].position;
        pose.orientation = slerp_shorter(frames[i].orientation, frames[i + 1].orientation, u);
    }
    return pose;
}

UnitQuaternion rolling_turn(const glm::vec2& way, float radius)
{
    // A long way is many turns: only what is left of the last one may be rounded.
    const double distance = std::sqrt(double(way.x) * way.x + double(way.y) * way.y);
    const double half = std::fmod(0.5 * distance / radius, 2 * std::acos(-1.0));
    const double scale = distance > 0 ? std::sin(half) / distance : 0.0;
    return {float(std::cos(half)), float(scale) * glm::vec3(way.y, 0, -way.x)};
}

std::unique_ptr<BouncingBall> make_bouncing_ball(const BallLaunch& launch)
{
    return std::make_unique<Simulation>(launch);
}

SkeletonPlaces skeleton_places(const TwoBoneSkeleton& skeleton, const SkeletonPose& pose)
{
    const auto [upper, lower] = bones(skeleton, pose);
    const glm::vec4 elbow(skeleton.shoulder + glm::vec3(skeleton.upper_length, 0, 0), 1);
    return {glm::vec3(upper * elbow), glm::vec3(lower * (elbow + glm::vec4(skeleton.lower_length, 0, 0, 0)))};
}

glm::vec3 skinned_point(const TwoBoneSkeleton& skeleton, const SkeletonPose& pose, const glm::vec3& rest,
                        float lower_weight)
{
    const auto [upper, lower] = bones(skeleton, pose);
    return glm::vec3(((1 - lower_weight) * upper + lower_weight * lower) * glm::vec4(rest, 1));
}

}
