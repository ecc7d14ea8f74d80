#include <gtest/gtest.h>

#include <interaction/support.hpp>
#include <numbers>

#include "../solution.hpp"
#include "../view_errors.hpp"

using namespace umbral;
using namespace umbral::interaction;
using MakeCamera = std::unique_ptr<OrbitCamera>(const OrbitCameraSettings&);

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Every test here holds for the reference and for the oracle.
class OrbitSolution : public testing::TestWithParam<const char*> {
protected:
    MakeCamera* const make = tests::solution<MakeCamera>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, OrbitSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

void expect_near(const glm::mat4& got, const glm::mat4& rows, double tolerance)
{
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            EXPECT_NEAR(got[column][row], rows[row][column], tolerance) << "row " << row << ", column " << column;
}

/// Where the camera stands in the world, from its matrix: -Rᵀ t.
glm::dvec3 eye_of(const OrbitCamera& camera)
{
    const glm::dmat4 view(camera.view());
    return -(glm::dvec3(view[3]) * glm::dmat3(view));
}

void expect_eye(const OrbitCamera& camera, glm::dvec3 place, double tolerance = 2e-6)
{
    EXPECT_LE(distance(eye_of(camera), place), tolerance)
        << "expected to stand at " << place.x << " " << place.y << " " << place.z;
}

}

// Worked by hand; the matrices are written by rows, as on paper.
TEST_P(OrbitSolution, beginnings)
{
    expect_near(make({})->view(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -5, 0, 0, 0, 1}, 0);
    expect_near(make({.distance = 3, .yaw = pi / 2})->view(), {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, -3, 0, 0, 0, 1},
                1e-15);
    expect_near(make({.target = {1, 2, 3}, .distance = 7})->view(),
                {1, 0, 0, -1, 0, 1, 0, -2, 0, 0, 1, -10, 0, 0, 0, 1}, 0);
    const float c = 0.8660254F;
    expect_near(make({.distance = 4, .pitch = pi / 6})->view(),
                {1, 0, 0, 0, 0, c, -0.5F, 0, 0, 0.5F, c, -4, 0, 0, 0, 1}, 1e-7);
}

TEST_P(OrbitSolution, the_scene_follows_the_hand)
{
    const auto camera = make({.distance = 2, .viewport_height = 400});
    camera->drag(200, 0);
    expect_eye(*camera, {-2, 0, 0});
    camera->drag(-400, 0);
    expect_eye(*camera, {2, 0, 0});
    camera->drag(0, -100);
    expect_eye(*camera, {std::sqrt(2), std::sqrt(2), 0});
    // The point of the scene that is nearest to the camera goes where the hand goes.
    const auto fresh = make({.distance = 2, .viewport_height = 400});
    fresh->drag(10, 10);
    const glm::vec4 front = fresh->view() * glm::vec4(0, 0, 1, 1);
    EXPECT_GT(front.x, 0);
    EXPECT_GT(front.y, 0);
}

TEST_P(OrbitSolution, pitch_stops_and_comes_back_at_once)
{
    const auto camera = make({.distance = 1, .viewport_height = 180});
    camera->drag(0, -1e6);
    const double limit = glm::radians(89.0);
    expect_eye(*camera, {0, std::sin(limit), std::cos(limit)});
    camera->drag(0, 29);
    expect_eye(*camera, {0, std::sin(pi / 3), 0.5});
    camera->drag(0, 1e300);
    expect_eye(*camera, {0, -std::sin(limit), std::cos(limit)});
}

TEST_P(OrbitSolution, the_wheel_multiplies)
{
    const auto camera = make({.distance = 5, .min_distance = 1, .max_distance = 8});
    const auto distance_after = [&](double steps) {
        camera->scroll(steps);
        return -camera->view()[3].z;
    };
    EXPECT_NEAR(distance_after(1), 4.5454545, 1e-6);
    EXPECT_NEAR(distance_after(-2), 5.5, 1e-6);
    EXPECT_NEAR(distance_after(0.5), 5.2440442, 1e-6);
    EXPECT_EQ(distance_after(100), 1);
    EXPECT_NEAR(distance_after(-1), 1.1F, 1e-7);
    EXPECT_EQ(distance_after(-1e308), 8);
    EXPECT_EQ(distance_after(1e308), 1);
}

TEST_P(OrbitSolution, resize_changes_what_a_pixel_is_worth_and_nothing_else)
{
    const auto camera = make({.distance = 2, .viewport_height = 400});
    camera->drag(100, 0);
    const glm::mat4 before = camera->view();
    camera->resize(100, 800);
    EXPECT_EQ(camera->view(), before);
    camera->drag(200, 0);
    expect_eye(*camera, {-2, 0, 0});
    for (const glm::ivec2 size : {glm::ivec2(0, 0), {0, 300}, {300, 0}, {-5, 300}, {300, -300}})
        camera->resize(size.x, size.y);
    camera->drag(400, 0);
    expect_eye(*camera, {0, 0, -2});
    camera->reset();
    expect_near(camera->view(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -2, 0, 0, 0, 1}, 0);
    camera->drag(400, 0);
    expect_eye(*camera, {-2, 0, 0});
}

TEST_P(OrbitSolution, nonsense_and_nothing_change_nothing)
{
    const auto camera = make({.target = {1, 2, 3}, .yaw = 1, .pitch = 0.5});
    const glm::mat4 before = camera->view();
    for (const double odd : {not_a_number, infinity, -infinity}) {
        camera->drag(odd, 5);
        camera->drag(5, odd);
        camera->scroll(odd);
    }
    camera->drag(0, 0);
    camera->drag(-0.0, 0);
    camera->scroll(0);
    EXPECT_EQ(camera->view(), before);
}

// The target stays in the middle, at the distance; up stays up; the matrix is a rotation and a translation.
TEST_P(OrbitSolution, looks_at_its_target_always)
{
    constexpr std::uint64_t seed = 20271;
    Random random(seed);
    for (int session = 0; session < 100; ++session) {
        OrbitCameraSettings settings = random_settings(random);
        settings.target =
            glm::dvec3(glm::vec3(settings.target));  // a float, so that the product below is the matrix's only error
        const auto camera = make(settings);
        for (const CameraEvent& event : random_session(random, 40)) {
            apply(*camera, event);
            const glm::dmat4 view(camera->view());
            const glm::dvec3 seen(view * glm::dvec4(settings.target, 1));
            // Of each entry, rotation and translation, 1e-7 of what it is multiplied with.
            ASSERT_LE(length(glm::dvec2(seen)), 3e-7 * (length(settings.target) - seen.z))
                << "seed " << seed << ", session " << session;
            ASSERT_GE(-seen.z, settings.min_distance * (1 - 4e-6));
            ASSERT_LE(-seen.z, settings.max_distance * (1 + 4e-6));
            ASSERT_EQ(view[1].x, 0) << "the world's y has no part to the side";
            ASSERT_GE(view[1].y, std::cos(settings.max_pitch) - 1e-7) << "and points up";
            ASSERT_NEAR(determinant(glm::dmat3(view)), 1, 5e-7);
        }
    }
}

TEST_P(OrbitSolution, cameras_share_nothing)
{
    const auto first = make({.yaw = 1});
    const glm::mat4 before = first->view();
    const auto second = make({.yaw = -1});
    second->drag(100, 30);
    second->scroll(3);
    second->resize(10, 10);
    EXPECT_EQ(first->view(), before);
}

namespace {

/// The worst error of the rotation in a session of `drags`, each of up to ten turns to the same side.
double drift(MakeCamera* make, std::uint64_t seed, int drags)
{
    static MakeCamera* const oracle = tests::solution<MakeCamera>(ORACLE_MODULE);
    const OrbitCameraSettings settings{.target = {0.5, -0.25, 1}, .distance = 3, .yaw = 0.3};
    const auto camera = make(settings);
    const auto exact = oracle(settings);
    Random random(seed);
    double worst = 0;
    for (int i = 1; i <= drags; ++i) {
        const double right = 4800 + random_pixels(random, 4800);
        const double up = random_pixels(random, 60);
        for (OrbitCamera* each : {camera.get(), exact.get()}) {
            each->drag(right, up);
            each->scroll(i % 2 == 0 ? 2.5 : -2.5);
        }
        if (i % 500 == 0)
            worst = std::max({worst, tests::rotation_error(camera->view(), exact->view()),
                              tests::translation_error(camera->view(), exact->view()) / 3});
    }
    return worst;
}

}

// The header's guarantee after a million turns, and that the hard check tells the forms apart.
TEST(OrbitAccuracy, a_million_turns)
{
    for (const std::uint64_t seed : {20272, 20273})
        EXPECT_LE(drift(tests::solution<MakeCamera>(REFERENCE_MODULE), seed, 200'000), 1e-7) << "seed " << seed;
    EXPECT_GT(drift(tests::solution<MakeCamera>(ANGLES_IN_FLOAT_MODULE), 20272, 200'000), 1e-4) << "sums in float";
}

TEST(OrbitAccuracy, far_targets)
{
    constexpr std::uint64_t seed = 20274;
    Random random(seed);
    for (int i = 0; i < 3000; ++i) {
        OrbitCameraSettings settings = random_settings(random);
        settings.target = glm::dvec3(std::pow(10.0F, random.uniform(0, 6)) * random.unit_vector());
        const auto camera = tests::solution<MakeCamera>(REFERENCE_MODULE)(settings);
        const auto exact = tests::solution<MakeCamera>(ORACLE_MODULE)(settings);
        for (const CameraEvent& event : random_session(random, 5)) {
            apply(*camera, event);
            apply(*exact, event);
        }
        ASSERT_LE(tests::rotation_error(camera->view(), exact->view()), 1e-7) << "seed " << seed << ", camera " << i;
        ASSERT_LE(tests::translation_error(camera->view(), exact->view()),
                  1e-7 * (length(settings.target) + settings.max_distance))
            << "seed " << seed;
    }
}
