#include <gtest/gtest.h>

#include <interaction/three-mode-camera/steps.hpp>

#include "../solution.hpp"
#include "../view_errors.hpp"

using namespace umbral;
using namespace umbral::interaction;
using MakeCamera = std::unique_ptr<ThreeModeCamera>(const ThreeModeSettings&);

namespace {

constexpr double pi = std::numbers::pi;

/// Every test here holds for the reference and for the oracle.
class ThreeModes : public testing::TestWithParam<const char*> {
protected:
    MakeCamera* const make = tests::solution<MakeCamera>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, ThreeModes, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

/// Where the camera stands in the world, from its matrix: -Rᵀ t.
glm::dvec3 observer_of(const ThreeModeCamera& camera)
{
    const glm::dmat4 view(camera.view());
    return -(glm::dvec3(view[3]) * glm::dmat3(view));
}

void expect_at(glm::dvec3 got, glm::dvec3 expected, double tolerance = 3e-6)
{
    EXPECT_LE(distance(got, expected), tolerance) << "got " << got.x << " " << got.y << " " << got.z << ", expected "
                                                  << expected.x << " " << expected.y << " " << expected.z;
}

}

// The course's worked numbers, with the signs that keep the observer where he is.
TEST_P(ThreeModes, the_observer_stays_where_the_slides_move_him)
{
    const auto turned = make({.mode = CameraMode::turn});
    turned->move_xy(0.5, 0.2);
    expect_at(observer_of(*turned), {0, 0, 3});
    expect_at(turned->attention_point(), {-1.40960, -0.596008, 0.419731}, 1e-5);

    const auto aimed = make({});
    aimed->look_toward({1, 2, -1});
    expect_at(observer_of(*aimed), {0, 0, 3});
    expect_at(aimed->attention_point(), {1, 2, -1}, 1e-14);
}

TEST_P(ThreeModes, distances_of_the_course)
{
    for (const auto& [steps, r] : {std::pair{1.0, 3.29}, {-1.0, 2.7363636}, {5.0, 4.770479}, {-5.0, 1.900672}}) {
        const auto camera = make({});
        camera->move_z(steps);
        EXPECT_NEAR(-camera->view()[3].z, r, 5e-7) << steps << " steps";
    }
}

TEST_P(ThreeModes, each_mode_moves_in_its_own_way)
{
    const auto camera = make({.azimuth = pi / 2, .distance = 2});
    camera->move_xy(pi / 2, 0);
    expect_at(observer_of(*camera), {0, 0, -2});
    camera->next_mode();
    camera->move_xy(1, 3);  // to the right of who looks along +z is -x
    expect_at(observer_of(*camera), {-1, 3, -2});
    camera->move_z(-4);
    expect_at(observer_of(*camera), {-1, 3, 2});
    camera->next_mode();
    camera->move_xy(-pi / 2, 0);
    expect_at(observer_of(*camera), {-1, 3, 2});
    expect_at(camera->attention_point(), {-3, 3, 2});
    camera->next_mode();
    EXPECT_EQ(camera->mode(), CameraMode::examine);
}

TEST_P(ThreeModes, steps_lead_back_from_every_limit)
{
    const auto camera = make({.min_distance = 0.5, .max_distance = 20});
    const auto r = [&] { return -camera->view()[3].z; };
    for (int i = 0; i < 10'000; ++i) camera->move_z(-1);
    EXPECT_NEAR(r(), 0.5005, 1e-7);
    camera->move_z(1);
    EXPECT_NEAR(r(), 0.50055, 1e-7);
    for (int i = 0; i < 10'000; ++i) camera->move_z(1);
    EXPECT_EQ(r(), 20);
    camera->move_z(-1);
    EXPECT_NEAR(r(), 0.5 + 19.5 / 1.1, 2e-6);
}

TEST_P(ThreeModes, poles_keep_the_azimuth)
{
    const auto camera = make({.azimuth = 0.7});
    camera->move_xy(0, 9);
    expect_at(observer_of(*camera), {0, 3, 0});
    EXPECT_NEAR(camera->view()[0].x, std::cos(0.7), 1e-7);
    camera->move_xy(0, -pi / 4);
    expect_at(observer_of(*camera), 3 * std::sqrt(0.5) * glm::dvec3(std::sin(0.7), 1, std::cos(0.7)));

    const auto below = make({.azimuth = 0.7, .mode = CameraMode::move});
    const glm::dvec3 observer(3 * std::sin(0.7), 0, 3 * std::cos(0.7));
    below->look_toward(observer - glm::dvec3(0, 2, 0));
    expect_at(observer_of(*below), observer);
    EXPECT_NEAR(below->view()[0].x, std::cos(0.7), 1e-7);
    EXPECT_EQ(below->mode(), CameraMode::examine);
}

TEST_P(ThreeModes, the_observer_lies_in_no_direction)
{
    const auto camera = make({.mode = CameraMode::turn});
    const glm::mat4 before = camera->view();
    camera->look_toward({0, 0, 3});
    camera->look_toward({0, std::numeric_limits<double>::infinity(), 3});
    EXPECT_EQ(camera->view(), before);
    EXPECT_EQ(camera->mode(), CameraMode::turn);
}

// Whatever is done: the attention point is in the middle of the picture, within the limits of the distance; the world's
// y axis is upright; the matrix is a rotation and a translation; and turns, aims and modes leave the observer alone.
TEST_P(ThreeModes, laws_of_random_sessions)
{
    constexpr std::uint64_t seed = 20401;
    Random random(seed);
    for (int session = 0; session < 200; ++session) {
        const ThreeModeSettings settings = random_three_mode(random);
        const auto camera = make(settings);
        for (const ThreeModeStep& step : random_steps(random, 60)) {
            const glm::dvec3 before = observer_of(*camera);
            const bool stays = step.kind == ThreeModeStep::Kind::look_toward ||
                               step.kind == ThreeModeStep::Kind::next_mode ||
                               (step.kind == ThreeModeStep::Kind::move_xy && camera->mode() == CameraMode::turn);
            apply(*camera, step);
            SCOPED_TRACE("seed " + std::to_string(seed) + ", session " + std::to_string(session));
            if (stays) {
                ASSERT_LE(distance(observer_of(*camera), before), 2e-5);
            }
            const glm::dmat4 view(camera->view());
            const glm::dvec3 seen(view * glm::dvec4(camera->attention_point(), 1));
            ASSERT_LE(length(glm::dvec2(seen)), 1e-5);
            ASSERT_GE(-seen.z, 1.001 * settings.min_distance - 1e-5);
            ASSERT_LE(-seen.z, settings.max_distance + 1e-5);
            ASSERT_EQ(view[1].x, 0);
            ASSERT_GE(view[1].y, -1e-15);
            ASSERT_NEAR(determinant(glm::dmat3(view)), 1, 5e-7);
        }
    }
}

TEST_P(ThreeModes, cameras_share_nothing)
{
    const auto first = make({.azimuth = 1});
    const glm::mat4 before = first->view();
    const auto second = make({.azimuth = -1});
    second->move_xy(1, 0.3);
    second->look_toward({4, 5, 6});
    second->next_mode();
    EXPECT_EQ(first->view(), before);
    EXPECT_EQ(first->mode(), CameraMode::examine);
}

namespace {

/// The worst error in a session of `count` steps about a place: of the rotation, or of the translation in parts of
/// |a| + r.
double drift(MakeCamera* make, std::uint64_t seed, int count, const glm::dvec3& place)
{
    Random random(seed);
    ThreeModeSettings settings = random_three_mode(random);
    settings.attention += place;
    const auto camera = make(settings);
    const auto exact = tests::solution<MakeCamera>(ORACLE_MODULE)(settings);
    double worst = 0;
    for (const ThreeModeStep& step : random_steps(random, count, place)) {
        apply(*camera, step);
        apply(*exact, step);
        const double size = length(exact->attention_point()) + settings.min_distance;
        worst = std::max({worst, tests::rotation_error(camera->view(), exact->view()),
                          tests::translation_error(camera->view(), exact->view()) / size});
    }
    return worst;
}

}

// The header's guarantee, and that float does not keep it.
TEST(ThreeModeAccuracy, far_away_and_after_many_steps)
{
    MakeCamera* const reference = tests::solution<MakeCamera>(REFERENCE_MODULE);
    for (const std::uint64_t seed : {20402, 20403, 20404}) {
        EXPECT_LE(drift(reference, seed, 20'000, glm::dvec3(0)), 1.2e-7) << "seed " << seed;
        EXPECT_LE(drift(reference, seed, 300, {6e5, -7e5, 4e5}), 1.2e-7) << "seed " << seed;
    }
    EXPECT_GT(drift(tests::solution<MakeCamera>(IN_FLOAT_MODULE), 20402, 300, {6e5, -7e5, 4e5}), 1e-4);
}
