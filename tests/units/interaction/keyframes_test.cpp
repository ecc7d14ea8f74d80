#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>
#include <interaction/keyframes/motions.hpp>
#include <limits>
#include <numbers>
#include <stdexcept>

// Linked with the reference; what is expected are numbers worked by hand, GLM's quaternions in double, or a law.

using namespace umbral;
using namespace umbral::interaction;

namespace {

constexpr double pi = std::numbers::pi;

glm::dquat wide(const UnitQuaternion& q) { return glm::normalize(glm::dquat(q.w, glm::dvec3(q.v))); }

double difference(const glm::mat3& a, const glm::mat3& b)
{
    double worst = 0;
    for (int i = 0; i < 9; ++i) worst = std::max(worst, std::abs(double{a[i / 3][i % 3]} - double{b[i / 3][i % 3]}));
    return worst;
}

double difference(const UnitQuaternion& got, const glm::dquat& expected)
{
    return difference(matrix_of(got), glm::mat3(glm::mat3_cast(expected)));
}

/// Where a ball is after each half second at this rate, seen through position().
std::vector<glm::dvec3> path(const BallLaunch& launch, std::int64_t rate)
{
    const auto ball = make_bouncing_ball(launch);
    std::vector<glm::dvec3> places;
    for (std::int64_t k = 1; k <= 60 * rate; ++k) {
        ball->advance(frame_time(k, rate) - frame_time(k - 1, rate));
        if (k % (rate / 2) == 0) places.push_back(ball->position());
    }
    return places;
}

}

TEST(Keyframes, a_third_of_a_quarter_turn)
{
    const UnitQuaternion third = slerp_shorter({}, about({0, 0, 1}, pi / 2), 1.0F / 3);
    EXPECT_NEAR(third.w, 0.9659258F, 1e-7);
    EXPECT_NEAR(third.v.z, 0.2588190F, 1e-7);
    // Half a turn: the way is that of the quaternions as given.
    EXPECT_LE(difference(slerp_shorter({}, {0, {0, 0, -1}}, 0.5F), glm::angleAxis(-pi / 2, glm::dvec3(0, 0, 1))), 3e-7);
}

TEST(Keyframes, slerp_is_that_of_glm)
{
    constexpr std::uint64_t seed = 20601;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const UnitQuaternion from = random_orientation(random);
        UnitQuaternion to = random_orientation(random);
        if (i % 4 == 0) to = product(about(glm::dvec3(random.unit_vector()), std::pow(10.0, -i % 9)), from);
        if (i % 8 == 0) to = negated(to);
        const float u = random.uniform();
        const UnitQuaternion got = slerp_shorter(from, to, u);
        ASSERT_NEAR(length(glm::dvec4(glm::dvec3(got.v), got.w)), 1, 3e-7) << "seed " << seed;
        ASSERT_LE(difference(got, glm::slerp(wide(from), wide(to), double{u})), 1e-6) << "seed " << seed << ", " << i;
        ASSERT_LE(difference(slerp_shorter(from, to, 0), wide(from)), 5e-7);
        ASSERT_LE(difference(slerp_shorter(from, to, 1), wide(to)), 5e-7);
    }
}

// Equal turns in equal times, never more than half a turn, and the same path backwards.
TEST(Keyframes, slerp_turns_evenly_by_the_shorter_way)
{
    constexpr std::uint64_t seed = 20602;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const UnitQuaternion from = random_orientation(random);
        const UnitQuaternion to = random_orientation(random);
        const double whole = 2 * std::acos(std::min(1.0, std::abs(glm::dot(wide(from), wide(to)))));
        for (const float u : {0.125F, 0.5F, 0.75F}) {
            const UnitQuaternion got = slerp_shorter(from, to, u);
            const double part = 2 * std::acos(std::min(1.0, std::abs(glm::dot(wide(from), wide(got)))));
            ASSERT_NEAR(part, u * whole, 2e-6 / std::max(0.01, part)) << "seed " << seed;
            ASSERT_LE(difference(matrix_of(got), matrix_of(slerp_shorter(to, from, 1 - u))), 1e-6);
        }
    }
}

TEST(Keyframes, poses_before_between_and_after)
{
    const std::vector<KeyFrame> frames{{1, {0, 0, 0}, {}},
                                       {3, {4, 0, -2}, about({0, 1, 0}, pi / 2)},
                                       {3, {8, 8, 8}, about({1, 0, 0}, pi)},
                                       {5, {8, 9, 8}, {}}};
    EXPECT_EQ(key_pose(frames, -9).position, glm::vec3(0));
    EXPECT_EQ(key_pose(frames, 1.5F).position, glm::vec3(1, 0, -0.5F));
    EXPECT_LE(difference(key_pose(frames, 2).orientation, glm::angleAxis(pi / 4, glm::dvec3(0, 1, 0))), 3e-7);
    EXPECT_EQ(key_pose(frames, 3).position, glm::vec3(8)) << "a cut";
    EXPECT_EQ(key_pose(frames, 4.5F).position, glm::vec3(8, 8.75F, 8));
    EXPECT_EQ(key_pose(frames, 1e30F).position, glm::vec3(8, 9, 8));
    EXPECT_THROW((void)key_pose({}, 1), std::invalid_argument);
    EXPECT_THROW((void)key_pose(frames, std::numeric_limits<float>::quiet_NaN()), std::invalid_argument);
}

// The point of the ball that touches the floor rests: velocity of the middle and turn cancel there.
TEST(Keyframes, rolling_does_not_slip)
{
    constexpr std::uint64_t seed = 20603;
    Random random(seed);
    EXPECT_EQ(rolling_turn({0, 0}, 2).w, 1);
    for (int i = 0; i < 500; ++i) {
        const glm::vec2 direction = glm::normalize(glm::vec2(random.in_cube()));
        const float radius = random.uniform(0.5F, 3);
        const glm::dvec3 down(0, -radius, 0);
        const float step = 1e-3F;
        const glm::dvec3 turned = wide(rolling_turn(step * direction, radius)) * down - down;
        const glm::dvec3 moved(step * direction.x, 0, step * direction.y);
        ASSERT_LE(length(turned + moved), 2e-6) << "seed " << seed;
        // After a full circumference all is as before.
        const auto whole = static_cast<float>(2 * pi * double{radius});
        ASSERT_LE(difference(rolling_turn(whole * direction, radius), glm::dquat(1, 0, 0, 0)), 2e-6);
    }
}

TEST(Keyframes, the_same_path_at_all_frame_rates)
{
    constexpr std::uint64_t seed = 20604;
    Random random(seed);
    for (int i = 0; i < 10; ++i) {
        const BallLaunch launch = random_launch(random);
        const std::vector<glm::dvec3> slow = path(launch, 10);
        for (const std::int64_t rate : {24, 60, 144, 1000}) EXPECT_EQ(path(launch, rate), slow) << "seed " << seed;
    }
}

// Between bounces, steps of semi-implicit Euler have a closed form: y = y0 + v0 t - g t (t + h) / 2.
TEST(Keyframes, free_fall_of_the_course_of_steps)
{
    const auto ball = make_bouncing_ball({.position = {1, 50, 2}, .velocity = {3, 5, -1}});
    for (int step = 1; step <= 500; ++step) {
        ball->advance(5000);
        const double t = 0.005 * (step - 1);
        const glm::dvec3 expected(1 + 3 * t, 50 + 5 * t - 9.81 * t * (t + 0.005) / 2, 2 - t);
        ASSERT_LE(distance(ball->position(), expected), 1e-11) << "step " << step;
    }
    const auto still = make_bouncing_ball({.position = {0, 1, 0}});
    still->advance(5000);
    EXPECT_EQ(still->position().y, 1);
    still->advance(2500);
    EXPECT_NEAR(still->position().y, 0.999877375, 1e-12);
    still->advance(-2500);
    still->advance(0);
    EXPECT_NEAR(still->position().y, 0.999877375, 1e-12);
}

TEST(Keyframes, bones_keep_their_lengths_and_follow_glm)
{
    constexpr std::uint64_t seed = 20605;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const TwoBoneSkeleton skeleton = random_skeleton(random);
        const SkeletonPose pose = random_skeleton_pose(random);
        const auto [elbow, hand] = skeleton_places(skeleton, pose);
        ASSERT_NEAR(distance(elbow, skeleton.shoulder), skeleton.upper_length, 2e-6) << "seed " << seed;
        ASSERT_NEAR(distance(hand, elbow), skeleton.lower_length, 2e-6);
        const glm::dquat both = wide(pose.shoulder) * wide(pose.elbow);
        const glm::dvec3 expected = glm::dvec3(elbow) + both * glm::dvec3(skeleton.lower_length, 0, 0);
        ASSERT_LE(distance(glm::dvec3(hand), expected), 2e-6);

        const glm::vec3 rest = skeleton.shoulder + 2.0F * random.in_cube();
        const glm::vec3 upper = skinned_point(skeleton, pose, rest, 0);
        const glm::vec3 lower = skinned_point(skeleton, pose, rest, 1);
        const float weight = random.uniform();
        ASSERT_NEAR(distance(upper, skeleton.shoulder), distance(rest, skeleton.shoulder), 4e-6);
        ASSERT_LE(distance(skinned_point(skeleton, pose, rest, weight), glm::mix(upper, lower, weight)), 4e-6F);
    }
}
