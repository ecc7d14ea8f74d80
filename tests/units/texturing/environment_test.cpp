#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>
#include <umbral/texturing/environment.hpp>

// Linked with the reference. What is expected was worked out by hand, is GLM's (reflect, perspective, lookAt), OpenGL's
// formula for spherical maps, or follows from going there and back.

using namespace umbral;
using namespace umbral::texturing;

namespace {

void expect_near(const glm::vec3& actual, const glm::dvec3& expected, double tolerance, std::uint64_t seed)
{
    for (int i = 0; i < 3; ++i) ASSERT_NEAR(actual[i], expected[i], tolerance) << "seed " << seed;
}

void expect_near(const glm::vec2& actual, const glm::dvec2& expected, double tolerance, std::uint64_t seed)
{
    for (int i = 0; i < 2; ++i) ASSERT_NEAR(actual[i], expected[i], tolerance) << "seed " << seed;
}

}

TEST(Environment, known_answers)
{
    EXPECT_EQ(mirrored_direction({1, 0, 1}, {0, 0, 1}), glm::vec3(-1, 0, 1));
    const BoxPlace place = box_place({4, 2, 1});
    EXPECT_EQ(place.face, BoxFace::right);
    EXPECT_EQ(place.uv, glm::vec2(0.625F, 0.75F));
    EXPECT_EQ(box_direction(place), glm::vec3(1, 0.5F, 0.25F));
    EXPECT_EQ(panorama_place({0, 0, -2}), glm::vec2(0.5F));
    EXPECT_EQ(panorama_place({3, 0, 0}), glm::vec2(0.75F, 0.5F));
    EXPECT_EQ(sphere_place({0, 0, 1}), glm::vec2(0.5F));
    expect_near(sphere_place({3, 0, 4}), glm::dvec2(0.5 + 0.5 * std::sqrt(0.1), 0.5), 1e-7, 0);
}

TEST(Environment, seams_are_where_the_interface_says)
{
    for (const float zero : {0.0F, -0.0F}) {
        EXPECT_EQ(panorama_place({zero, 0, 1}), glm::vec2(1, 0.5F));
        EXPECT_EQ(panorama_place({zero, 5, -zero}), glm::vec2(0.5F, 1));
        EXPECT_EQ(panorama_place({zero, -5, zero}), glm::vec2(0.5F, 0));
        EXPECT_EQ(sphere_place({zero, zero, -7}), glm::vec2(1, 0.5F));
    }
    EXPECT_EQ(box_place({1, 1, 1}).face, BoxFace::right);
    EXPECT_EQ(box_place({0.5F, -1, -1}).face, BoxFace::bottom);
    EXPECT_EQ(sphere_direction({0, 0}), glm::vec3(0, 0, -1));
}

TEST(Environment, mirrors_agree_with_glm)
{
    constexpr std::uint64_t seed = 20341;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 to_eye = 3.0F * random.in_cube();
        const glm::vec3 n = random.unit_vector();
        expect_near(mirrored_direction(to_eye, n), glm::reflect(-glm::dvec3(to_eye), glm::dvec3(n)), 1e-6, seed);
    }
}

// Each face is what a camera at the centre sees through a square window of 90 degrees.
TEST(Environment, faces_are_what_a_camera_sees)
{
    constexpr std::uint64_t seed = 20342;
    constexpr double right_angle = 1.5707963267948966;
    const glm::dmat4 projection = glm::perspective(right_angle, 1.0, 0.1, 10.0);
    const glm::dvec3 ahead[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const glm::dvec3 up[] = {{0, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 1, 0}, {0, 1, 0}};
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 direction = random.uniform(0.5F, 5) * random.unit_vector();
        const BoxPlace place = box_place(direction);
        const auto face = static_cast<std::size_t>(place.face);
        const glm::dvec4 clip =
            projection * glm::lookAt(glm::dvec3(0), ahead[face], up[face]) * glm::dvec4(direction, 1);
        ASSERT_GT(clip.w, 0);
        expect_near(place.uv, 0.5 + 0.5 * glm::dvec2(clip) / clip.w, 1e-6, seed);
    }
}

TEST(Environment, spherical_maps_agree_with_opengl)
{
    constexpr std::uint64_t seed = 20343;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 r = random.unit_vector();
        const glm::dvec3 sum = glm::dvec3(r) + glm::dvec3(0, 0, 1);
        expect_near(sphere_place(r), 0.5 + 0.5 * glm::dvec2(sum) / length(sum), 2e-6, seed);
    }
}

// There and back, at every length that a float has.
TEST(Environment, places_lead_back_to_their_directions)
{
    constexpr std::uint64_t seed = 20344;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 unit = random.unit_vector();
        const glm::vec3 direction = std::exp2(random.uniform(-120, 120)) * unit;
        expect_near(panorama_direction(panorama_place(direction)), unit, 1e-6, seed);
        expect_near(glm::normalize(box_direction(box_place(direction))), unit, 1e-6, seed);
        // Beside the rim a place is worth little: the root of 1 - x² - y² is as uncertain as that of a rounding.
        const double tolerance = unit.z < -0.99F ? 2e-3 : 4e-6;
        expect_near(sphere_direction(sphere_place(direction)), unit, tolerance, seed);
    }
}
