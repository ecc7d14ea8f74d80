#include <kit/refusal.hpp>
#include <limits>
#include <numbers>
#include <umbral/record/driver.hpp>

#include "film.hpp"

namespace umbral {
namespace {

using namespace interaction;

constexpr double pi = std::numbers::pi;
constexpr float infinity = std::numeric_limits<float>::infinity();

void record_slerp(Recorder& out, const UnitQuaternion& from, const UnitQuaternion& to, float u)
{
    out.append("orientation", matrix_of(ask<slerp_shorter>(out, from, to, u)));
}

// Quarter turns and the like, from and to all sides, and which half of a turn is taken.
void record_known_turns(Variation& vary, Recorder& out)
{
    const UnitQuaternion none;
    for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {1, 1, 1}})
        for (const float written : {0.0F, 0.25F, 1.0F / 3, 0.5F, 1.0F}) {
            const float u = written == std::round(written) ? written : vary.near(written, 0.15F);
            record_slerp(out, none, about(axis, vary.near(pi / 2, 0.3)), u);
            record_slerp(out, about(axis, -pi / 3), about(axis, 2 * pi / 3), u);
        }
    record_slerp(out, {1, {0, 0, 0}}, {0, {1, 0, 0}}, vary.near(0.25F, 0.15F));
    record_slerp(out, {1, {0, 0, 0}}, {0, {0, 0, -1}}, vary.near(0.25F, 0.15F));
    record_slerp(out, {0, {0, 1, 0}}, {0, {0, 0, -1}}, vary.near(0.75F, 0.15F));
}

void record_random_turns(Recorder& out, Random& random)
{
    for (int i = 0; i < 400; ++i) {
        const UnitQuaternion from = random_orientation(random);
        const UnitQuaternion to = random_orientation(random);
        record_slerp(out, from, to, random_part(random, i));
    }
}

// Ends whose quaternions lie on opposite sides, though the turn between them is small or middling.
void record_longer_ways(Recorder& out, Random& random)
{
    for (int i = 0; i < 100; ++i) {
        const UnitQuaternion from = random_orientation(random);
        const UnitQuaternion turn = about(glm::dvec3(random.unit_vector()), 0.2 + 2.4 * random.uniform_double());
        const UnitQuaternion to = product(turn, from);
        record_slerp(out, from, random.below(4) == 0 ? to : negated(to), random.uniform());
    }
    // Just less than half a turn, and just more: which way is shorter hangs on a small product.
    for (int i = 0; i < 24; ++i) {
        const UnitQuaternion from = random_orientation(random);
        const double beside = std::pow(10.0, -5 + 3 * random.uniform_double());
        const UnitQuaternion turn = about(glm::dvec3(random.unit_vector()), i % 2 == 0 ? pi - beside : pi + beside);
        record_slerp(out, from, product(turn, from), random.uniform(0.2F, 0.8F));
    }
}

// Ends that are equal, opposite, or differ by very little: within float, and by more.
void record_near_turns(Recorder& out, Random& random)
{
    for (int i = 0; i < 120; ++i) {
        const UnitQuaternion from = random_orientation(random);
        const double angle = i % 3 == 0 ? 0 : std::pow(10.0, -8 + 6 * random.uniform_double());
        const UnitQuaternion to = i % 3 == 0 ? from : product(about(glm::dvec3(random.unit_vector()), angle), from);
        record_slerp(out, from, random.below(2) == 0 ? to : negated(to), random.uniform());
    }
}

void record_pose(Recorder& out, const std::vector<KeyFrame>& frames, float seconds)
{
    const auto [position, orientation] = ask<key_pose>(out, frames, seconds);
    out.append("position", position);
    out.append("orientation", matrix_of(orientation));
}

// Frames for a hand: before, at, between and after them; one frame only; and cuts.
void record_known_frames(Variation& vary, Recorder& out)
{
    const std::vector<KeyFrame> three = varied(
        vary,
        {{1, {0, 0, 0}, {}}, {3, {4, 0, -2}, about({0, 1, 0}, pi / 2)}, {4, {4, 8, 0}, about({1, 0, 0}, pi / 2)}});
    for (const float seconds : {2.0F, 0.0F, 1.0F, 1.5F, 3.0F, 3.25F, 4.0F, 9.0F, 3.75F, -infinity, infinity})
        record_pose(out, three, seconds);
    const std::vector<KeyFrame> one = varied(vary, {{2, {1, 2, 3}, about({0, 0, 1}, 1)}});
    for (const float seconds : {1.0F, 2.0F, 3.0F}) record_pose(out, one, seconds);
    for (const float seconds : {1.0F, 2.0F, 1.999F, 2.5F, 3.5F}) record_pose(out, varied(vary, known_cut()), seconds);
    for (const float seconds : {0.0F, 1.0F, 2.0F, 3.0F, 4.0F})
        record_pose(out, varied(vary, known_cuts_at_the_ends()), seconds);
}

void record_random_frames(Recorder& out, Random& random)
{
    for (int i = 0; i < 60; ++i) {
        const std::vector<KeyFrame> frames = random_frames(random, 1 + random.below(8));
        for (int k = 0; k < 4; ++k) record_pose(out, frames, random_time(random, frames));
        record_pose(out, frames, frames[random.below(static_cast<std::uint32_t>(frames.size()))].seconds);
    }
    // Hardly before a cut, where rounding has no say yet.
    for (int i = 0; i < 12; ++i) {
        const std::vector<KeyFrame> frames = frames_with_cut(random);
        record_pose(out, frames, frames[1].seconds - random.uniform(1e-5F, 5e-5F));
    }
}

// In random order one that is refused and one that is not.
void record_refused(Recorder& out, Random& random)
{
    for (int i = 0; i < 20; ++i) {
        const std::vector<KeyFrame> frames = random_frames(random, 1 + random.below(3));
        const bool bad_first = random.below(2) == 0;
        for (const bool is_bad : {bad_first, !bad_first}) {
            const bool is_empty = is_bad && i % 2 == 0;
            const float seconds = is_bad && i % 2 == 1 ? std::numeric_limits<float>::quiet_NaN() : 0.5F;
            record_refusal(out, "refused",
                           [&] { return ask<key_pose>(out, is_empty ? std::vector<KeyFrame>{} : frames, seconds); });
        }
    }
}

void record_rolling(Recorder& out, Random& random)
{
    const auto record = [&](const glm::vec2& way, float radius) {
        out.append("orientation", matrix_of(ask<rolling_turn>(out, way, radius)));
    };
    for (const glm::vec2 way : {glm::vec2(0, 0), {1, 0}, {0, 1}, {-2, 0}, {0, -0.5F}, {3, 4}}) record(way, 2);
    for (int i = 0; i < 9; ++i) record({0, 0}, random.uniform(0.2F, 3));
    for (int i = 0; i < 60; ++i) {
        const glm::vec2 way = 4.0F * glm::vec2(random.in_cube());
        record(way, random.uniform(0.2F, 3));
    }
    for (const float size : {1e-12F, 1e-8F, 1e-4F, 1e4F, 1e8F})
        for (int i = 0; i < 3; ++i) {
            const glm::vec2 way = 4.0F * size * glm::vec2(random.in_cube());
            record(way, size * random.uniform(0.5F, 3));
        }
}

// A thousand turns: in float an angle of 10^4 radians is known to 5e-4.
void record_long_ways(Recorder& out, Random& random)
{
    for (int i = 0; i < 40; ++i) {
        const glm::vec2 way = std::pow(10.0F, random.uniform(2, 3.5F)) * glm::vec2(random.in_cube());
        out.append("orientation", matrix_of(ask<rolling_turn>(out, way, random.uniform(0.2F, 3))));
    }
}

/// A ball's places at common times of all rates: every half second.
void record_path(Recorder& out, const BallLaunch& launch, std::int64_t rate, std::string_view name)
{
    const std::unique_ptr<BouncingBall> ball = ask_new<make_bouncing_ball>(out, "ball", launch);
    if (!ball) return;
    for (std::int64_t k = 1; k <= 4 * rate; ++k) {
        ask<&BouncingBall::advance>(out, *ball, frame_time(k, rate) - frame_time(k - 1, rate));
        if (k % (rate / 2) == 0) out.append(name, glm::vec3(ask<&BouncingBall::position>(out, *ball)));
    }
}

void record_rates(Recorder& out, Random& random)
{
    for (int i = 0; i < 6; ++i) {
        const BallLaunch launch = random_launch(random);
        record_path(out, launch, 10, "10 a second");
        record_path(out, launch, 60, "60 a second");
        record_path(out, launch, 144, "144 a second");
    }
}

// Pictures at odd times, some of them before the first step; times that stand still or go back change nothing.
void record_odd_times(Recorder& out, Random& random)
{
    for (int i = 0; i < 8; ++i) {
        const std::unique_ptr<BouncingBall> ball = ask_new<make_bouncing_ball>(out, "ball", random_launch(random));
        if (!ball) continue;
        out.append("place", glm::vec3(ask<&BouncingBall::position>(out, *ball)));
        for (int k = 0; k < 24; ++k) {
            const std::uint32_t kind = random.below(6);
            const std::int64_t some = 1 + random.below(kind < 3 ? 4900 : 150'000);
            const std::int64_t nothing = k % 2 == 0 ? 0 : -some;
            ask<&BouncingBall::advance>(out, *ball, kind == 5 ? nothing : some);
            out.append("place", glm::vec3(ask<&BouncingBall::position>(out, *ball)));
        }
    }
    // Steep throws, looked at in the air after one long call, in which some have met the floor and kept all of their
    // speed, or only when an hour has gone by in one.
    for (int i = 0; i < 12; ++i) {
        const bool keeps_all = i % 4 == 2;
        const auto ball = ask_new<make_bouncing_ball>(out, "ball", random_throw(random, keeps_all));
        if (!ball) continue;
        const std::int64_t in_the_air = (keeps_all ? 1'500'000 : 260'000) + std::int64_t{random.below(150'000)};
        ask<&BouncingBall::advance>(out, *ball, i % 2 == 0 ? in_the_air : 3'600'000'000);
        out.append("place", glm::vec3(ask<&BouncingBall::position>(out, *ball)));
    }
}

/// All the digits of a double.
void record_digits_of(Recorder& out, const BouncingBall& ball)
{
    const glm::dvec3 place = ask<&BouncingBall::position>(out, ball);
    out.append("place", glm::dvec2(place.x, place.y));
}

// All the digits of a double, in pictures that come from one microsecond to 20 ms after each other; half of the balls
// come to rest meanwhile.
void record_digits(Recorder& out, Random& random)
{
    for (int i = 0; i < 6; ++i) {
        BallLaunch launch = random_launch(random);
        if (i % 2 == 1) launch.bounce -= 0.45;
        const std::unique_ptr<BouncingBall> ball = ask_new<make_bouncing_ball>(out, "ball", launch);
        if (!ball) continue;
        for (int k = 1; k <= 400; ++k) {
            ask<&BouncingBall::advance>(out, *ball, k % 4 == 0 ? 1 : 1 + std::int64_t{random.below(20'000)});
            if (k % 16 == 0) record_digits_of(out, *ball);
        }
    }
    // Balls that a step leaves a hair above the floor or below it.
    for (int i = 0; i < 12; ++i) {
        const int steps = 20 + static_cast<int>(random.below(60));
        const double height = (i % 2 == 0 ? 1 : -1) * std::pow(10.0, -7 + 3 * random.uniform_double());
        const auto ball = ask_new<make_bouncing_ball>(out, "ball", launch_that_lands(random, steps, height));
        if (!ball) continue;
        for (const std::int64_t time : {steps * 5'000, 1'000, 200'000}) {
            ask<&BouncingBall::advance>(out, *ball, time);
            record_digits_of(out, *ball);
        }
    }
}

/// Two balls in turns; what one is told must not reach the other.
void record_two(Recorder& out, Random& random)
{
    const std::unique_ptr<BouncingBall> first = ask_new<make_bouncing_ball>(out, "first", random_launch(random));
    if (!first) return;
    ask<&BouncingBall::advance>(out, *first, 123'456);
    const std::unique_ptr<BouncingBall> second = ask_new<make_bouncing_ball>(out, "second", random_launch(random));
    if (!second) return;
    for (int k = 0; k < 40; ++k) {
        ask<&BouncingBall::advance>(out, random.below(2) == 0 ? *first : *second, 1 + random.below(150'000));
        out.append("place", glm::vec3(ask<&BouncingBall::position>(out, *first)));
        out.append("place", glm::vec3(ask<&BouncingBall::position>(out, *second)));
    }
}

void record_skeleton(Recorder& out, const TwoBoneSkeleton& skeleton, const SkeletonPose& pose)
{
    const auto [elbow, hand] = ask<skeleton_places>(out, skeleton, pose);
    out.append("elbow", elbow);
    out.append("hand", hand);
}

void record_skeletons(Recorder& out, Random& random)
{
    const UnitQuaternion quarter = about({0, 0, 1}, pi / 2);
    const UnitQuaternion forwards = about({0, 1, 0}, -pi / 2);
    for (const SkeletonPose& pose : {SkeletonPose{}, {quarter, {}}, {{}, quarter}, {quarter, forwards}})
        record_skeleton(out, {{1, 2, 0}, 2, 1}, pose);
    for (int i = 0; i < 80; ++i) {
        const TwoBoneSkeleton skeleton = random_skeleton(random);
        record_skeleton(out, skeleton, random_skeleton_pose(random));
    }
}

void record_skin(Recorder& out, Random& random)
{
    for (int i = 0; i < 120; ++i) {
        const TwoBoneSkeleton skeleton = random_skeleton(random);
        const SkeletonPose pose = random_skeleton_pose(random);
        const glm::vec3 rest = skeleton.shoulder + 2.0F * random.in_cube();
        out.append("point", ask<skinned_point>(out, skeleton, pose, rest, random_part(random, i)));
    }
}

}

const Driver driver = {
    {"known turns", [](Case& c, Recorder& out) { record_known_turns(c.vary, out); }},
    {"random turns", [](Case& c, Recorder& out) { record_random_turns(out, c.random); }},
    {"longer ways", [](Case& c, Recorder& out) { record_longer_ways(out, c.random); }},
    {"near turns", [](Case& c, Recorder& out) { record_near_turns(out, c.random); }},
    {"known frames", [](Case& c, Recorder& out) { record_known_frames(c.vary, out); }},
    {"random frames", [](Case& c, Recorder& out) { record_random_frames(out, c.random); }},
    {"refused", [](Case& c, Recorder& out) { record_refused(out, c.random); }},
    {"rolling", [](Case& c, Recorder& out) { record_rolling(out, c.random); }},
    {"long ways", [](Case& c, Recorder& out) { record_long_ways(out, c.random); }},
    {"frame rates", [](Case& c, Recorder& out) { record_rates(out, c.random); }},
    {"odd times", [](Case& c, Recorder& out) { record_odd_times(out, c.random); }},
    {"digits", [](Case& c, Recorder& out) { record_digits(out, c.random); }},
    {"two balls", [](Case& c, Recorder& out) { record_two(out, c.random); }},
    {"skeleton", [](Case& c, Recorder& out) { record_skeletons(out, c.random); }},
    {"skin", [](Case& c, Recorder& out) { record_skin(out, c.random); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", film(c.vary, out)); }},
};

}
