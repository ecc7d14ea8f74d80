#include <kit/numbers_changed.hpp>
#include <kit/refusal.hpp>
#include <limits>
#include <numbers>
#include <umbral/record/driver.hpp>

#include "balls.hpp"
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
        if (i % 10 != 0) continue;
        // Another end, another beginning, and then turns whose axes lack a coordinate; each alone is another one.
        const float u = random.uniform(0.1F, 0.9F);
        const UnitQuaternion end = about_flat_axis(random, i / 10 % 3);
        for (const auto& [one, other] : {std::pair(from, end),
                                         {to, end},
                                         {about_flat_axis(random, (i / 10 + 1) % 3), end},
                                         {UnitQuaternion{}, end}})
            record_slerp(out, one, other, u);
    }
}

// From one of the quaternions 1, i, j, k and their opposites to another: their product is 0 without rounding.
void record_half_turn(Recorder& out, Random& random)
{
    glm::vec4 ends[2] = {};
    const std::uint32_t first = random.below(4);
    const std::uint32_t second = (first + 1 + random.below(3)) % 4;
    ends[0][static_cast<int>(first)] = random.below(2) == 0 ? 1.0F : -1.0F;
    ends[1][static_cast<int>(second)] = random.below(2) == 0 ? 1.0F : -1.0F;
    record_slerp(out, {ends[0].w, glm::vec3(ends[0])}, {ends[1].w, glm::vec3(ends[1])}, random.uniform(0.2F, 0.8F));
}

// Ends whose quaternions lie on opposite sides, though the turn between them is small or middling.
void record_longer_ways(Recorder& out, Random& random)
{
    for (int i = 0; i < 100; ++i) {
        const UnitQuaternion from = random_orientation(random);
        const UnitQuaternion turn = about(glm::dvec3(random.unit_vector()), 0.2 + 2.4 * random.uniform_double());
        const UnitQuaternion to = product(turn, from);
        record_slerp(out, from, random.below(4) == 0 ? to : negated(to), random.uniform());
        // Exactly half a turn: whatever came before, neither end changes its sign.
        if (i % 4 != 3) continue;
        record_slerp(out, from, negated(to), random.uniform());
        record_half_turn(out, random);
    }
    // Just less than half a turn, and just more: which way is shorter hangs on a small product.
    for (int i = 0; i < 24; ++i) {
        const UnitQuaternion from = random_orientation(random);
        const double beside = std::pow(10.0, -5 + 3 * random.uniform_double());
        const UnitQuaternion turn = about(glm::dvec3(random.unit_vector()), i % 2 == 0 ? pi - beside : pi + beside);
        record_slerp(out, from, product(turn, from), random.uniform(0.2F, 0.8F));
    }
}

// Ends that are equal, opposite, or differ by very little: within float, and by more. Angles of all sizes come evenly:
// so whoever turns by none, or by all, is near enough in about as many rows each time.
void record_near_turns(Recorder& out, Random& random)
{
    for (int i = 0; i < 120; ++i) {
        const UnitQuaternion from = random_orientation(random);
        const double angle = i % 3 == 0 ? 0 : std::pow(10.0, -8 + 7.75 * (i + random.uniform_double()) / 120);
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
    // The same time in other frames: each has moved in turn, along one axis mostly. Then nothing moves from one to the
    // next; and the last one comes twice.
    for (int i = 0; i < 12; ++i) {
        std::vector<KeyFrame> frames = frames_with_cut(random);
        const float part = random.uniform(0.1F, 0.9F);
        const float seconds = frames[0].seconds + part * (frames[1].seconds - frames[0].seconds);
        for (std::size_t k = 0; k < 2; ++k) {
            frames[k].position[i % 3] = i % 2 == 0 ? 0 : frames[k].position[i % 3] + random.uniform(1, 3);
            record_pose(out, frames, seconds);
            frames[k].orientation = about_flat_axis(random, i % 3);
            record_pose(out, frames, seconds);
        }
        frames[1].position = frames[0].position;
        record_pose(out, frames, seconds);
        frames.push_back(frames.back());
        for (const float later : {0.0F, 1.0F}) record_pose(out, frames, frames.back().seconds + later);
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
    for (int i = 0; i < 6; ++i) {
        // The same way on another ball, and along one axis only.
        const float radius = random.uniform(0.5F, 2);
        const glm::vec2 way = 3.0F * glm::vec2(random.in_cube());
        record(way, radius);
        record(way, radius * random.uniform(1.2F, 1.8F));
        record({way.x, 0}, radius);
        record({0, way.y}, radius);
        record({way.x, way.x}, radius);
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

void record_skeleton(Recorder& out, const TwoBoneSkeleton& skeleton, const SkeletonPose& pose)
{
    const auto [elbow, hand] = ask<skeleton_places>(out, skeleton, pose);
    out.append("elbow", elbow);
    out.append("hand", hand);
}

using Skin = std::tuple<TwoBoneSkeleton, glm::vec3, float>;

/// Skeletons, points and weights that differ in one number each, which may be 0, with the same pose; then one joint
/// after the other is turned about an axis that lacks a coordinate, or not at all.
std::vector<std::pair<Skin, SkeletonPose>> changed_skins(Random& random)
{
    const auto allowed = [](const Skin& skin) {
        const auto& [skeleton, rest, weight] = skin;
        return skeleton.upper_length > 0.1F && skeleton.lower_length > 0.1F && weight <= 1;
    };
    std::vector<std::pair<Skin, SkeletonPose>> all;
    for (int i = 0; i < 8; ++i) {
        SkeletonPose pose = random_skeleton_pose(random);
        const TwoBoneSkeleton skeleton = random_skeleton(random);
        const glm::vec3 rest = skeleton.shoulder + 2.0F * random.in_cube();
        for (const Skin& skin : numbers_changed(random, Skin(skeleton, rest, random.uniform(0.1F, 0.9F)), 6, allowed))
            all.emplace_back(skin, pose);
        for (const bool is_turned : {true, false})
            for (UnitQuaternion* const joint : {&pose.elbow, &pose.shoulder}) {
                *joint = is_turned ? about_flat_axis(random, i % 3) : UnitQuaternion{};
                all.emplace_back(all.back().first, pose);
            }
    }
    return all;
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
    for (const auto& [skin, pose] : changed_skins(random)) record_skeleton(out, std::get<0>(skin), pose);
}

void record_skin(Recorder& out, Random& random)
{
    for (int i = 0; i < 120; ++i) {
        const TwoBoneSkeleton skeleton = random_skeleton(random);
        const SkeletonPose pose = random_skeleton_pose(random);
        const glm::vec3 rest = skeleton.shoulder + 2.0F * random.in_cube();
        out.append("point", ask<skinned_point>(out, skeleton, pose, rest, random_part(random, i)));
    }
    for (const auto& [skin, pose] : changed_skins(random)) {
        const auto& [skeleton, rest, lower_weight] = skin;
        out.append("point", ask<skinned_point>(out, skeleton, pose, rest, lower_weight));
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
