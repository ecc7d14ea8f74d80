#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <umbral/core/random.hpp>

#include "../solution.hpp"
#include "cameras_functions.hpp"

using namespace umbral;
using namespace umbral::projections;

namespace {

/// Every test here holds for the reference and for the oracle.
class CamerasSolution : public testing::TestWithParam<const char*> {
protected:
    const CamerasFunctions& solution() const { return *tests::solution_table<CamerasFunctions>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Solutions, CamerasSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

struct Matrices final : MatrixTarget {
    void set_view(const glm::mat4& matrix) override { view = matrix; }
    void set_projection(const glm::mat4& matrix) override { projection = matrix; }

    glm::mat4 view{0};
    glm::mat4 projection{0};
};

Matrices matrices_of(Camera& camera)
{
    Matrices matrices;
    camera.activate(matrices);
    return matrices;
}

void expect_near(const glm::mat4& got, const glm::dmat4& expected)
{
    for (int column = 0; column < 4; ++column) {
        const glm::dvec4 size = abs(expected[column]);
        const double largest = std::max({size.x, size.y, size.z, size.w});
        for (int row = 0; row < 4; ++row)
            EXPECT_NEAR(got[column][row], expected[column][row], 6e-8 * size[row] + 1e-9 * largest)
                << "column " << column << ", row " << row;
    }
}

}

TEST_P(CamerasSolution, base_camera_shows_a_square_as_a_square)
{
    const std::unique_ptr<Camera> camera = solution().base();
    expect_near(matrices_of(*camera).projection, glm::ortho(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0));
    camera->set_viewport(200, 100);
    expect_near(matrices_of(*camera).projection, glm::ortho(-1.0, 1.0, -0.5, 0.5, -1.0, 1.0));
    EXPECT_EQ(matrices_of(*camera).view, glm::mat4(1));
    for (const glm::ivec2& none : {glm::ivec2(0, 0), {0, 5}, {5, 0}, {-5, 5}}) camera->set_viewport(none.x, none.y);
    expect_near(matrices_of(*camera).projection, glm::ortho(-1.0, 1.0, -0.5, 0.5, -1.0, 1.0));
}

// What the statement works out.
TEST_P(CamerasSolution, known_answers)
{
    const std::unique_ptr<OrbitalCamera> camera = solution().orbital(90, 0, 2);
    const glm::vec4 seen = matrices_of(*camera).view * glm::vec4(1, 0, 0, 1);
    EXPECT_LT(distance(glm::vec3(seen), glm::vec3(0, 0, -1)), 1e-7F);
    camera->set_viewport(400, 200);
    EXPECT_NEAR(matrices_of(*camera).projection[0][0], std::sqrt(3.0) / 2, 6e-8);
}

// GLM's look-at with an up vector that turns with the camera, so that it works at the poles and beyond.
TEST_P(CamerasSolution, orbital_camera_is_look_at_and_perspective)
{
    constexpr std::uint64_t seed = 31101;
    Random random(seed);
    const std::unique_ptr<OrbitalCamera> camera = solution().orbital(1, 2, 3);
    for (int i = 0; i < 2000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", camera " + std::to_string(i));
        const float a_degrees = random.uniform(-2000, 2000);
        const float b_degrees = random.uniform(-2000, 2000);
        const float distance = std::pow(10.0F, random.uniform(-1, 3));
        const int width = 1 + static_cast<int>(random.below(3000));
        const int height = 1 + static_cast<int>(random.below(3000));
        camera->set_angles(a_degrees, b_degrees);
        camera->set_distance(distance);
        camera->set_viewport(width, height);
        const double a = glm::radians(double{a_degrees});
        const double b = glm::radians(double{b_degrees});
        const glm::dvec3 eye(std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a));
        const glm::dvec3 up(-std::sin(b) * std::sin(a), std::cos(b), -std::sin(b) * std::cos(a));
        const Matrices got = matrices_of(*camera);
        expect_near(got.view, glm::lookAt(double{distance} * eye, glm::dvec3(0), up));
        expect_near(got.projection,
                    glm::perspective(glm::radians(60.0), static_cast<double>(width) / height, 0.05, 1000.05));
        if (HasFailure()) return;
    }
}

TEST_P(CamerasSolution, refused_numbers_change_nothing)
{
    const std::unique_ptr<OrbitalCamera> camera = solution().orbital(10, 20, 3);
    const glm::mat4 before = matrices_of(*camera).view;
    const float infinity = std::numeric_limits<float>::infinity();
    const float no_number = std::numeric_limits<float>::quiet_NaN();
    for (const float wrong : {0.0F, -1.0F, no_number, infinity}) {
        EXPECT_THROW(camera->set_distance(wrong), std::invalid_argument);
        EXPECT_THROW((void)solution().orbital(0, 0, wrong), std::invalid_argument);
    }
    for (const float wrong : {no_number, infinity, -infinity}) {
        EXPECT_THROW(camera->set_angles(wrong, 1), std::invalid_argument);
        EXPECT_THROW(camera->set_angles(1, wrong), std::invalid_argument);
        EXPECT_THROW((void)solution().orbital(wrong, 0, 1), std::invalid_argument);
        EXPECT_THROW((void)solution().orbital(0, wrong, 1), std::invalid_argument);
    }
    EXPECT_EQ(matrices_of(*camera).view, before);
}

TEST_P(CamerasSolution, cameras_share_nothing)
{
    const std::unique_ptr<OrbitalCamera> first = solution().orbital(10, 20, 3);
    const Matrices before = matrices_of(*first);
    const std::unique_ptr<OrbitalCamera> second = solution().orbital(70, -20, 5);
    second->set_viewport(7, 3);
    second->set_angles(1, 2);
    (void)matrices_of(*second);
    EXPECT_EQ(matrices_of(*first).view, before.view);
    EXPECT_EQ(matrices_of(*first).projection, before.projection);
}

// The header's guarantee, for angles of any size.
TEST(CamerasAccuracy, whole_turns_cost_nothing)
{
    constexpr std::uint64_t seed = 31102;
    const CamerasFunctions& reference = *tests::solution_table<CamerasFunctions>(REFERENCE_MODULE);
    const CamerasFunctions& oracle = *tests::solution_table<CamerasFunctions>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const float size = std::pow(10.0F, random.uniform(0, 30));
        const float a = size * random.uniform(-1, 1);
        const float b = size * random.uniform(-1, 1);
        expect_near(matrices_of(*reference.orbital(a, b, 2)).view,
                    glm::dmat4(matrices_of(*oracle.orbital(a, b, 2)).view));
        ASSERT_FALSE(HasFailure()) << "seed " << seed << ", camera " << i;
    }
}
