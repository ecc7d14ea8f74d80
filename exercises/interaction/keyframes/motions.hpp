#pragma once

#include <array>
#include <cmath>
#include <kit/axial.hpp>
#include <umbral/core/random.hpp>
#include <umbral/interaction/keyframes.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// Questions of the keyframes unit, and canonical forms of its answers.
namespace umbral::interaction {

inline UnitQuaternion about(const glm::dvec3& axis, double angle)
{
    return {static_cast<float>(std::cos(0.5 * angle)), glm::vec3(std::sin(0.5 * angle) * glm::normalize(axis))};
}

inline UnitQuaternion negated(const UnitQuaternion& q) { return {-q.w, -q.v}; }

/// Any orientation, each equally often in direction.
inline UnitQuaternion random_orientation(Random& random)
{
    const glm::dvec3 axis(random.unit_vector());
    return about(axis, 6.2 * random.uniform_double());
}

/// About an axis that lies in a plane of two axes, or along one: a coordinate is 0, or two are.
inline UnitQuaternion about_flat_axis(Random& random, int missing)
{
    const glm::dvec3 axis(axial_vector(random, missing));
    return about(axis, 0.3 + 2.2 * random.uniform_double());
}

/// One turn after another: the right one acts first.
inline UnitQuaternion product(const UnitQuaternion& a, const UnitQuaternion& b)
{
    return {a.w * b.w - glm::dot(a.v, b.v), a.w * b.v + b.w * a.v + glm::cross(a.v, b.v)};
}

/// The matrix of an orientation, which both of its quaternions have. One that is not of length 1 scales, too.
inline glm::mat3 matrix_of(const UnitQuaternion& q)
{
    const glm::dvec3 v(q.v);
    const double w = q.w;
    const double even = w * w - glm::dot(v, v);
    glm::dmat3 m(0);
    for (int column = 0; column < 3; ++column) {
        glm::dvec3 e(0);
        e[column] = 1;
        m[column] = even * e + 2 * glm::dot(v, e) * v + 2 * w * glm::cross(v, e);
    }
    return glm::mat3(m);
}

/// Three frames at one time, of which the first ends a way and the last begins one.
inline std::vector<KeyFrame> known_cut()
{
    return {{0, {0, 0, 0}, {}},
            {2, {2, 0, 0}, about({1, 0, 0}, 0.5)},
            {2, {9, 9, 9}, about({1, 0, 0}, 1)},
            {2, {5, 0, 5}, about({0, 1, 0}, 2)},
            {4, {5, 4, 5}, about({0, 1, 0}, 1)}};
}

/// Cuts at the first time and at the last.
inline std::vector<KeyFrame> known_cuts_at_the_ends()
{
    return {{1, {1, 0, 0}, {}},
            {1, {2, 0, 0}, about({0, 0, 1}, 1)},
            {3, {6, 0, 0}, about({0, 0, 1}, 2)},
            {3, {7, 0, 0}, about({0, 0, 1}, 3)}};
}

/// The same key frames elsewhere and seen from another side, if inputs are to vary: times are the same, and so are the
/// turns between the orientations.
inline std::vector<KeyFrame> varied(Variation& vary, std::vector<KeyFrame> frames)
{
    if (!vary) return frames;
    const UnitQuaternion side = about({1, 2, 3}, vary.near(0.0, 1.0));
    for (KeyFrame& frame : frames) {
        frame.position = vary.near(frame.position, 0.5F);
        frame.orientation = product(side, frame.orientation);
    }
    return frames;
}

/// A part from 0 to 1: every eighth time an end, and as often hardly beside one.
inline float random_part(Random& random, int i)
{
    const auto end = static_cast<float>(i % 16 / 8);
    if (i % 8 == 0) return end;
    return i % 8 == 4 ? std::abs(end - std::pow(10.0F, random.uniform(-4, -1.5F))) : random.uniform();
}

/// Key frames at random times, now and then two at one time: a cut. One list of three is as quick as microseconds, or
/// takes minutes.
inline std::vector<KeyFrame> random_frames(Random& random, std::uint32_t count)
{
    std::vector<KeyFrame> frames;
    const float pace = random.below(3) == 0 ? std::ldexp(1.0F, static_cast<int>(random.below(27)) - 20) : 1;
    float seconds = pace * random.uniform(-2, 2);
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec3 position = 5.0F * random.in_cube();
        frames.push_back({seconds, position, random_orientation(random)});
        if (random.below(4) != 0) seconds += pace * random.uniform(0.05F, 2);
    }
    return frames;
}

/// Four frames, of which the second and the third are a cut.
inline std::vector<KeyFrame> frames_with_cut(Random& random)
{
    std::vector<KeyFrame> frames = random_frames(random, 4);
    float seconds = random.uniform(-2, 2);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i].seconds = seconds;
        if (i != 1) seconds += random.uniform(0.5F, 2);
    }
    return frames;
}

/// A time that is not at a frame, from as long before the first to as long after the last as half of all takes.
inline float random_time(Random& random, const std::vector<KeyFrame>& frames)
{
    const float all = frames.back().seconds - frames.front().seconds;
    const float beside = all > 0 ? all / 2 : 1;
    return random.uniform(frames.front().seconds - beside, frames.back().seconds + beside);
}

/// A ball that is far from rest for four seconds.
inline BallLaunch random_launch(Random& random)
{
    BallLaunch launch;
    launch.position = glm::dvec3(2.0F * random.in_cube()) + glm::dvec3(0, 4, 0);
    launch.velocity = glm::dvec3(4.0F * random.in_cube());
    launch.bounce = 0.85 + 0.1 * random.uniform_double();
    return launch;
}

/// The ball is only let go; then it is thrown up from the floor, and at last straight up, above the world's origin,
/// where it keeps nothing of its speed when it is back.
inline std::vector<BallLaunch> special_launches(Random& random)
{
    BallLaunch dropped = random_launch(random);
    dropped.velocity = glm::dvec3(0);
    BallLaunch thrown = dropped;
    thrown.position.y = 0;
    thrown.velocity = {random.uniform(-2, 2), random.uniform(3, 5), 0};
    BallLaunch straight = thrown;
    straight.position = glm::dvec3(0);
    straight.velocity = {0, random.uniform(3, 5), 0};
    straight.bounce = 0;
    return {dropped, thrown, straight};
}

/// A ball thrown straight up, which comes down after half a second or later. Where it does not keep all of its speed it
/// soon lies still.
inline BallLaunch random_throw(Random& random, bool keeps_all)
{
    BallLaunch launch;
    launch.position = glm::dvec3(2.0F * random.in_cube());
    launch.position.y = 0.5 + random.uniform_double();
    launch.velocity.y = 2 + random.uniform_double();
    launch.bounce = keeps_all ? 1 : 0.5 * random.uniform_double();
    return launch;
}

/// A ball that comes down, and that so many steps leave at this height, before it meets the floor.
inline BallLaunch launch_that_lands(Random& random, int steps, double height)
{
    constexpr double step = 0.005;
    BallLaunch launch;
    launch.position = glm::dvec3(2.0F * random.in_cube());
    launch.velocity = glm::dvec3(random.uniform(-2, 2), -random.uniform_double(), random.uniform(-2, 2));
    launch.position.y = height - steps * step * launch.velocity.y + 9.81 * step * step * steps * (steps + 1) / 2;
    launch.bounce = 0.5 + 0.4 * random.uniform_double();
    return launch;
}

/// A ball that meets the floor in the last of so many steps, and leaves it hardly faster than a step of gravity takes
/// away: by `rise`, in metres a second, which the next step leaves it.
inline BallLaunch launch_that_bounces_softly(Random& random, int steps, double rise)
{
    constexpr double step = 0.005;
    BallLaunch launch = launch_that_lands(random, steps, -1e-4);
    launch.bounce = (9.81 * step + rise) / (9.81 * step * steps - launch.velocity.y);
    return launch;
}

/// Times of pictures in microseconds: k / rate seconds, as near as whole microseconds come.
inline std::int64_t frame_time(std::int64_t k, std::int64_t rate) { return k * 1'000'000 / rate; }

inline SkeletonPose random_skeleton_pose(Random& random)
{
    const UnitQuaternion shoulder = random_orientation(random);
    return {shoulder, random_orientation(random)};
}

inline TwoBoneSkeleton random_skeleton(Random& random)
{
    TwoBoneSkeleton skeleton;
    skeleton.shoulder = 3.0F * random.in_cube();
    skeleton.upper_length = random.uniform(0.5F, 2);
    skeleton.lower_length = random.uniform(0.5F, 2);
    return skeleton;
}

}
