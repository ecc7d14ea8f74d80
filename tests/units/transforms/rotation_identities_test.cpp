#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <umbral/core/random.hpp>
#include <umbral/transforms/rotation_identities.hpp>

// Linked with the reference; what is expected are the identities of problems 2.12 to 2.14, and turns that are exact.

using namespace umbral;
using namespace umbral::transforms;

namespace {

constexpr WorldAxis axes[] = {WorldAxis::x, WorldAxis::y, WorldAxis::z};

ElementaryTurn any_turn(Random& random)
{
    const WorldAxis axis = axes[random.below(3)];
    return {axis, std::pow(10.0F, random.uniform(-6, 9)) * (random.below(2) == 0 ? 1.0F : -1.0F)};
}

}

TEST(RotationIdentities, known_answers)
{
    EXPECT_EQ(elementary_rotation({1, 2, 3}, {WorldAxis::x, 90}), glm::vec3(1, -3, 2));
    EXPECT_EQ(elementary_rotation({1, -3, 2}, {WorldAxis::y, 90}), glm::vec3(2, -3, -1));
    EXPECT_EQ(elementary_rotation({1, 2, 3}, {WorldAxis::z, -90}), glm::vec3(2, -1, 3));
    const ElementaryTurn both[] = {{WorldAxis::x, 90}, {WorldAxis::y, 90}};
    EXPECT_EQ(after_turns({1, 2, 3}, both), glm::vec3(2, -3, -1));
    EXPECT_FLOAT_EQ(elementary_matrix({WorldAxis::y, 60})[0][2], -0.8660254F);
}

TEST(RotationIdentities, quarter_turns_are_exact)
{
    for (const WorldAxis axis : axes) {
        for (int quarters = -180'000; quarters <= 180'000; quarters += 7) {
            const glm::vec3 v(0.1F, 0.2F, 0.3F);
            glm::vec3 expected = v;
            for (int i = 0; i < ((quarters % 4) + 4) % 4; ++i) expected = elementary_rotation(expected, {axis, 90});
            ASSERT_EQ(elementary_rotation(v, {axis, static_cast<float>(90 * quarters)}), expected) << quarters;
        }
    }
}

TEST(RotationIdentities, dot_length_and_cross_are_kept)
{
    constexpr std::uint64_t seed = 20301;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const ElementaryTurn turn = any_turn(random);
        const glm::vec3 a = random.unit_vector();
        const glm::vec3 b = random.unit_vector();
        const glm::dvec3 ra(elementary_rotation(a, turn));
        const glm::dvec3 rb(elementary_rotation(b, turn));
        ASSERT_NEAR(dot(ra, rb), dot(glm::dvec3(a), glm::dvec3(b)), 3e-7) << "seed " << seed << ", turn " << i;
        ASSERT_NEAR(length(ra), length(glm::dvec3(a)), 1e-7) << "seed " << seed << ", turn " << i;
        const glm::dvec3 crossed(elementary_rotation(glm::vec3(cross(glm::dvec3(a), glm::dvec3(b))), turn));
        ASSERT_LE(length(cross(ra, rb) - crossed), 4e-7) << "seed " << seed << ", turn " << i;
    }
}

// A chain about one axis is a turn by the sum of the degrees, which is exact here.
TEST(RotationIdentities, long_chain_turns_by_the_sum)
{
    const std::vector<ElementaryTurn> chain(1'000'000, {WorldAxis::y, 0.25F});
    const glm::vec3 a(0.6F, -0.64F, 0.48F);
    for (const std::size_t count : {std::size_t{360}, std::size_t{99'999}, chain.size()}) {
        const glm::vec3 by_sum = elementary_rotation(a, {WorldAxis::y, 0.25F * static_cast<float>(count)});
        EXPECT_LE(length(after_turns(a, std::span(chain).first(count)) - by_sum), 1.3e-7F) << count;
    }
}
