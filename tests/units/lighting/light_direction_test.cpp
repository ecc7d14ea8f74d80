#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <lighting/light-direction/keys.hpp>

#include "../solution.hpp"
#include "light_direction_functions.hpp"

using namespace umbral;
using namespace umbral::lighting;

namespace {

/// Every test here holds for the reference and for the oracle.
class LightDirectionSolution : public testing::TestWithParam<const char*> {
protected:
    const LightDirection& unit = *tests::solution<LightDirection>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, LightDirectionSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

glm::vec2 pair_of(const LightAngles& angles) { return {angles.longitude_degrees, angles.latitude_degrees}; }

LightAngles random_angles(Random& random)
{
    const float longitude = random.uniform(0, 360);
    return {longitude, random.uniform(-90, 90)};
}

}

// The statement's numbers.
TEST_P(LightDirectionSolution, known_answers)
{
    EXPECT_EQ(unit.light_direction({0, 0}), glm::vec3(0, 0, 1)) << "lab 4: 0 and 0 is +z";
    EXPECT_LT(length(unit.light_direction({90, 60}) - glm::vec3(0.5F, std::sqrt(0.75F), 0)), 1e-7F);
    EXPECT_LT(length(unit.light_direction({0, 30}) - glm::vec3(0, 0.5F, std::sqrt(0.75F))), 1e-7F) << "up";
    EXPECT_EQ(pair_of(unit.light_angles({-1, 0, 0})), glm::vec2(270, 0));
    EXPECT_EQ(pair_of(unit.light_angles({-0.0F, 2, -0.0F})), glm::vec2(0, 90));
    EXPECT_EQ(pair_of(unit.light_angles({0, 0, 0})), glm::vec2(0, 0));
    EXPECT_EQ(pair_of(unit.light_angles({-1e-30F, 0, 1})), glm::vec2(0, 0)) << "360 less a hair";
    const glm::mat4 from_the_right = glm::lookAt(glm::vec3(5, 0, 0), glm::vec3(0), glm::vec3(0, 1, 0));
    const glm::vec3 sun = unit.direction_in_camera({90, 0}, LightFrame::world, from_the_right);
    EXPECT_LT(length(sun - glm::vec3(0, 0, 1)), 1e-6F) << "behind the camera";
}

// GLM's rotations: about -x by the latitude, then about y by the longitude.
TEST_P(LightDirectionSolution, is_two_rotations_of_z)
{
    constexpr std::uint64_t seed = 20601;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const LightAngles angles = random_angles(random);
        const glm::dmat4 about_y =
            glm::rotate(glm::dmat4(1), glm::radians(double{angles.longitude_degrees}), glm::dvec3(0, 1, 0));
        const glm::dmat4 both =
            glm::rotate(about_y, glm::radians(double{angles.latitude_degrees}), glm::dvec3(-1, 0, 0));
        const glm::vec3 d = unit.light_direction(angles);
        ASSERT_LT(length(d - glm::vec3(both[2])), 1.2e-7F) << "seed " << seed;
        const LightAngles back = unit.light_angles(d);
        // Near a pole a step of the direction is many degrees of longitude, but few of the place in the sky.
        const glm::vec3 again = unit.light_direction(back);
        ASSERT_LT(length(again - d), 6e-7F) << "seed " << seed;
        ASSERT_GE(back.longitude_degrees, 0);
        ASSERT_LT(back.longitude_degrees, 360);
    }
}

TEST_P(LightDirectionSolution, frames_are_inverse_to_each_other)
{
    constexpr std::uint64_t seed = 20602;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const LightAngles angles = random_angles(random);
        const glm::mat4 view = random_view(random);
        const glm::vec3 d = unit.light_direction(angles);
        ASSERT_EQ(unit.direction_in_camera(angles, LightFrame::camera, view), d);
        ASSERT_EQ(unit.direction_in_world(angles, LightFrame::world, view), d);
        // Two points on the way to the light go through the matrix as points do.
        const glm::vec4 near = view * glm::vec4(1, 2, 3, 1);
        const glm::vec4 far = view * glm::vec4(glm::vec3(1, 2, 3) + d, 1);
        ASSERT_LT(length(unit.direction_in_camera(angles, LightFrame::world, view) - glm::vec3(far - near)), 6e-6F);
        const glm::vec3 lamp = unit.direction_in_world(angles, LightFrame::camera, view);
        // A matrix of floats has its transpose as inverse but for a few roundings in each entry.
        ASSERT_LT(length(glm::vec3(view * glm::vec4(lamp, 0)) - d), 2e-6F) << "seed " << seed;
    }
}

// Sessions of whole degrees against whole numbers.
TEST_P(LightDirectionSolution, keys_turn_by_whole_degrees)
{
    constexpr std::uint64_t seed = 20603;
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        const int step = 1 + static_cast<int>(random.below(60));
        int longitude = static_cast<int>(random.below(360));
        int latitude = static_cast<int>(random.below(181)) - 90;
        const auto control = unit.make_light_control({static_cast<float>(longitude), static_cast<float>(latitude)},
                                                     static_cast<float>(step));
        for (const char key : random_session(random, 80)) {
            const glm::vec2 before = pair_of(control->angles());
            const bool turned = control->press(key);
            if (key == 'x' || key == 'X') longitude = (longitude + step) % 360;
            if (key == 'c' || key == 'C') longitude = (longitude + 360 - step) % 360;
            if (key == 'a' || key == 'A') latitude = std::min(90, latitude + step);
            if (key == 'z' || key == 'Z') latitude = std::max(-90, latitude - step);
            ASSERT_EQ(pair_of(control->angles()), glm::vec2(longitude, latitude)) << "seed " << seed;
            ASSERT_EQ(turned, before != pair_of(control->angles())) << "seed " << seed << ", key " << key;
        }
    }
}

TEST_P(LightDirectionSolution, controls_share_nothing)
{
    const auto first = unit.make_light_control({10, 20}, 5);
    const auto second = unit.make_light_control({200, -40}, 1);
    EXPECT_TRUE(first->press('x'));
    EXPECT_EQ(pair_of(second->angles()), glm::vec2(200, -40));
    EXPECT_TRUE(second->press('Z'));
    EXPECT_EQ(pair_of(first->angles()), glm::vec2(15, 20));
}

// The header's guarantees, with many turns and a million keys.
TEST(LightDirectionReference, keeps_its_guarantees)
{
    constexpr std::uint64_t seed = 20604;
    const auto& reference = *tests::solution<LightDirection>(REFERENCE_MODULE);
    const auto& oracle = *tests::solution<LightDirection>(ORACLE_MODULE);
    Random random(seed);
    const auto near = [](float one, float other) {
        return one == other || std::nextafter(one, other) == other || std::abs(one - other) > 359.9F;
    };
    for (int i = 0; i < 50'000; ++i) {
        const LightAngles angles{random.uniform(-1e7F, 1e7F), random.uniform(-90, 90)};
        ASSERT_LE(length(reference.light_direction(angles) - oracle.light_direction(angles)), 1e-7F) << seed;
        const float size = std::pow(10.0F, random.uniform(-37, 37));
        const glm::vec3 d = size * (random.unit_vector() + glm::vec3(0, i % 3 == 0 ? 1e5F : 0, 0));
        if (std::isinf(d.y)) continue;
        ASSERT_TRUE(near(reference.light_angles(d).longitude_degrees, oracle.light_angles(d).longitude_degrees))
            << seed;
        ASSERT_TRUE(near(reference.light_angles(d).latitude_degrees, oracle.light_angles(d).latitude_degrees)) << seed;
    }
    const auto fast = reference.make_light_control({0, 0}, 0.1F);
    const auto exact = oracle.make_light_control({0, 0}, 0.1F);
    for (int i = 0; i < 1'000'000; ++i) {
        fast->press('x');
        exact->press('x');
    }
    EXPECT_NEAR(fast->angles().longitude_degrees, exact->angles().longitude_degrees, 3.1e-5F);
}
