#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <raytracing/rays.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "camera_rays_functions.hpp"

using namespace umbral;
using namespace umbral::raytracing;

namespace {

constexpr double right_angle = 1.5707963267948966;

/// Every test here holds for the reference and for the oracle.
class CameraRaysSolution : public testing::TestWithParam<const char*> {
protected:
    const CameraRaysFunctions& solution() const { return *tests::solution_table<CameraRaysFunctions>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Solutions, CameraRaysSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

PrimaryCamera random_camera(Random& random, float away, float distance)
{
    PrimaryCamera camera;
    camera.eye = away * random.in_cube();
    camera.target = camera.eye + distance * random.unit_vector();
    const glm::dvec3 view = normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
    camera.up = glm::vec3(0.7 * view + 0.5 * perpendicular_to(view, random));
    camera.fovy = random.uniform(0.1F, 2.5F);
    return camera;
}

void expect_near(const glm::vec3& got, const glm::dvec3& expected, double tolerance)
{
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], expected[i], tolerance) << "coordinate " << i;
}

}

// The course's numbers (problem 4.3): 640 x 480, the frustum -4/3, 4/3, -1, 1, 1.
TEST_P(CameraRaysSolution, known_answers_of_the_course)
{
    const PrimaryCamera camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, static_cast<float>(right_angle)};
    const Ray corner = solution().primary_ray(camera, 640, 480, {0.5F, 0.5F});
    expect_near(corner.direction, {-0.6858047233, 0.5140852308, -0.5151584776}, 1e-7);
    EXPECT_EQ(corner.origin, camera.eye);
    EXPECT_EQ(corner.t_min, 0);
    EXPECT_EQ(corner.t_max, endless);
    const Ray middle = solution().primary_ray(camera, 640, 480, {320.5F, 240.5F});
    expect_near(middle.direction, {0.0020833243, -0.0020833243, -0.9999956598}, 1e-7);
}

// Another way to the same ray: what GLM's matrices project to the place.
TEST_P(CameraRaysSolution, agrees_with_glm_unproject)
{
    constexpr std::uint64_t seed = 22001;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", camera " + std::to_string(i));
        const PrimaryCamera camera = random_camera(random, 3, 2);
        const int width = 1 + static_cast<int>(random.below(500));
        const int height = 1 + static_cast<int>(random.below(500));
        const glm::vec2 place(random.uniform(0, 1) * static_cast<float>(width),
                              random.uniform(0, 1) * static_cast<float>(height));
        const glm::dvec3 eye(camera.eye);
        const glm::dmat4 view = glm::lookAt(eye, glm::dvec3(camera.target), glm::dvec3(camera.up));
        const glm::dmat4 projection =
            glm::perspective(double{camera.fovy}, static_cast<double>(width) / height, 0.5, 8.0);
        const glm::dvec3 window(place.x, height - double{place.y}, 0.5);
        const glm::dvec3 point = glm::unProject(window, view, projection, glm::dvec4(0, 0, width, height));
        const Ray ray = solution().primary_ray(camera, width, height, place);
        expect_near(ray.direction, normalize(point - eye), 1e-7);
    }
}

TEST_P(CameraRaysSolution, samples_are_the_centres_of_small_squares)
{
    EXPECT_EQ(solution().pixel_samples(3, 5, 1), std::vector<glm::vec2>(1, {3.5F, 5.5F}));
    const std::vector<glm::vec2> four = {{3.25F, 5.25F}, {3.75F, 5.25F}, {3.25F, 5.75F}, {3.75F, 5.75F}};
    EXPECT_EQ(solution().pixel_samples(3, 5, 2), four);
    for (int n = 1; n < 12; ++n) {
        const std::vector<glm::vec2> places = solution().pixel_samples(7, 9, n);
        ASSERT_EQ(places.size(), static_cast<std::size_t>(n * n));
        glm::dvec2 sum(0);
        for (const glm::vec2& place : places) sum += glm::dvec2(place);
        EXPECT_NEAR(sum.x / (n * n), 7.5, 1e-6) << n;
        EXPECT_NEAR(sum.y / (n * n), 9.5, 1e-6) << n;
    }
}

// Half-planes of light: how many samples lie on each side is known.
TEST_P(CameraRaysSolution, pixels_are_means_of_their_samples)
{
    const PrimaryCamera camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, static_cast<float>(right_angle)};
    int asked = 0;
    const LightAlongRay light = [&](const Ray& ray) {
        ++asked;
        // The picture of 2 x 2 pixels shows x and y from -1 to 1 at distance 1: each pixel is 1 wide.
        const glm::vec3 at = ray.direction / -ray.direction.z;
        return glm::vec3(at.x > -0.5F ? 8 : 0, at.y > 0.3F ? 4 : 0, 1);
    };
    const Grid<glm::vec3> picture = solution().render_picture(camera, 2, 2, 4, light);
    EXPECT_EQ(asked, 64);
    EXPECT_EQ(picture.at(0, 0), glm::vec3(4, 3, 1)) << "upper left; rows at 7/8, 5/8, 3/8 and 1/8";
    EXPECT_EQ(picture.at(1, 0), glm::vec3(8, 3, 1));
    EXPECT_EQ(picture.at(0, 1), glm::vec3(4, 0, 1)) << "lower left";
    EXPECT_EQ(picture.at(1, 1), glm::vec3(8, 0, 1));
}

// The header's guarantee.
TEST(CameraRaysAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 22002;
    const auto& reference = *tests::solution_table<CameraRaysFunctions>(REFERENCE_MODULE);
    const auto& oracle = *tests::solution_table<CameraRaysFunctions>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", camera " + std::to_string(i));
        const float away = std::pow(10.0F, random.uniform(0, 6));
        PrimaryCamera camera = random_camera(random, away, away);
        const glm::dvec3 view = normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
        const double lean = std::pow(10.0, -3 * random.uniform_double());
        camera.up = glm::vec3(view + lean * perpendicular_to(view, random));
        camera.fovy = std::pow(10.0F, random.uniform(-4, 0.4F));
        const glm::vec2 place(random.uniform(-200, 900), random.uniform(-200, 700));
        const Ray got = reference.primary_ray(camera, 640, 480, place);
        expect_near(got.direction, glm::dvec3(oracle.primary_ray(camera, 640, 480, place).direction), 1e-7);
    }
    for (int n = 1; n < 9; ++n) EXPECT_EQ(reference.pixel_samples(639, 17, n), oracle.pixel_samples(639, 17, n));
}

TEST(CameraRaysAccuracy, float_fails_in_narrow_views_far_from_the_origin)
{
    const auto& in_float = *tests::solution_table<CameraRaysFunctions>(IN_FLOAT_MODULE);
    const auto& oracle = *tests::solution_table<CameraRaysFunctions>(ORACLE_MODULE);
    Random random(22003);
    int right = 0;
    for (int i = 0; i < 1000; ++i) {
        const PrimaryCamera camera = random_camera(random, 1e5F, 1e3F);
        const glm::vec3 got = in_float.primary_ray(camera, 64, 48, {10, 10}).direction;
        const glm::vec3 exact = oracle.primary_ray(camera, 64, 48, {10, 10}).direction;
        right += length(glm::dvec3(got) - glm::dvec3(exact)) < 1e-4 ? 1 : 0;
    }
    EXPECT_LT(right, 100);
}
