#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/polar_coordinates.hpp>
#include <umbral/core/random.hpp>
#include <umbral/texturing/coordinates.hpp>

// Linked with the reference. What is expected was worked out by hand, follows from a law, or is GLM's.

using namespace umbral;
using namespace umbral::texturing;

namespace {

constexpr float turn = 6.2831853F;

void expect_near(glm::vec2 actual, glm::vec2 expected, float tolerance, const std::string& about)
{
    EXPECT_NEAR(actual.x, expected.x, tolerance) << about;
    EXPECT_NEAR(actual.y, expected.y, tolerance) << about;
}

}

TEST(Coordinates, known_answers)
{
    EXPECT_EQ(spherical_coordinates({1, 0, 0}), glm::vec2(0.5F, 0.5F));
    EXPECT_EQ(spherical_coordinates({0, 0, 1}), glm::vec2(0.75F, 0.5F));
    EXPECT_EQ(spherical_coordinates({0, 0, -1}), glm::vec2(0.25F, 0.5F));
    EXPECT_EQ(spherical_coordinates({1, 1, 0}), glm::vec2(0.5F, 0.75F));
    expect_near(spherical_coordinates({1, 1.4142136F, 1}), {0.625F, 0.75F}, 1e-7F, "the statement's number");
    EXPECT_EQ(cylindrical_coordinates({0, 2.5F, 3}, 1, 4), glm::vec2(0.75F, 0.5F));
    EXPECT_EQ(planar_coordinates({2, 7, 13}, {{1, 2, 3}, {0, 0.6F, 0.8F}, {1, 0, 0}}), glm::vec2(11, 1));
    EXPECT_EQ(parametric_coordinates(2, 1),
              (std::vector<glm::vec2>{{0, 0}, {0.5F, 0}, {1, 0}, {0, 1}, {0.5F, 1}, {1, 1}}));
}

TEST(Coordinates, signs_of_zero_decide_nothing)
{
    for (const float zero : {0.0F, -0.0F}) {
        EXPECT_EQ(spherical_coordinates({-1, 0, zero}), glm::vec2(1, 0.5F));
        EXPECT_EQ(cylindrical_coordinates({-2, 0, zero}, 0, 1), glm::vec2(1, 0));
        for (const float other : {0.0F, -0.0F}) {
            EXPECT_EQ(spherical_coordinates({zero, 2, other}), glm::vec2(0.5F, 1));
            EXPECT_EQ(spherical_coordinates({zero, -2, other}), glm::vec2(0.5F, 0));
            EXPECT_EQ(spherical_coordinates({zero, -0.0F, other}), glm::vec2(0.5F, 0.5F));
        }
    }
}

TEST(Coordinates, a_cylinder_without_height_has_v_0)
{
    EXPECT_EQ(cylindrical_coordinates({1, 7, 0}, 2, 2), glm::vec2(0.5F, 0));
}

// GLM's polar coordinates: latitude, and longitude from +z towards +x.
TEST(Coordinates, spherical_agrees_with_glm)
{
    constexpr std::uint64_t seed = 20301;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const glm::dvec3 point = glm::dvec3(random.in_cube());
        const glm::dvec3 polar = glm::polar(point);
        double u = 0.5 + (turn / 4 - polar.y) / turn;
        u -= std::floor(u);
        const glm::vec2 actual = spherical_coordinates(point);
        const double around = std::abs(actual.x - u);
        ASSERT_LT(std::min(around, 1 - around), 4e-7) << "seed " << seed << ", point " << i;
        ASSERT_NEAR(actual.y, 0.5 + polar.x / (turn / 2), 4e-7) << "seed " << seed << ", point " << i;
    }
}

// Coordinates are an inverse: from (u, v) back to the direction, at every size that a float has.
TEST(Coordinates, spherical_leads_back_to_the_direction)
{
    constexpr std::uint64_t seed = 20302;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 direction = random.unit_vector();
        const float size = std::exp2(random.uniform(-120, 120));
        const glm::vec2 at = spherical_coordinates(direction * size);
        const double alpha = (at.x - 0.5) * 2 * M_PI;
        const double beta = (at.y - 0.5) * M_PI;
        const glm::dvec3 back(std::cos(beta) * std::cos(alpha), std::sin(beta), std::cos(beta) * std::sin(alpha));
        ASSERT_LT(distance(back, glm::dvec3(direction)), 1e-6) << "seed " << seed << ", point " << i;
    }
}

// Turning a point about the axis moves u by as much, and nothing else.
TEST(Coordinates, turning_moves_u)
{
    constexpr std::uint64_t seed = 20303;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const glm::vec3 point = random.in_cube();
        const float part = random.uniform();
        const glm::mat4 turned = glm::rotate(glm::mat4(1), -part * turn, {0, 1, 0});
        const glm::vec2 before = cylindrical_coordinates(point, -1, 1);
        const glm::vec2 after = cylindrical_coordinates(glm::vec3(turned * glm::vec4(point, 1)), -1, 1);
        const float moved = after.x - before.x - part;
        ASSERT_NEAR(moved, std::round(moved), 2e-5F) << "seed " << seed << ", point " << i;
        ASSERT_NEAR(after.y, before.y, 1e-6F) << "seed " << seed << ", point " << i;
    }
}

// The plane's point with coordinates (u, v) is origin + u u_axis + v v_axis, wherever it is moved along the normal.
// Axes of floats are unit and perpendicular to 4e-7 only, over distances of up to 5.
TEST(Coordinates, planar_leads_back_to_the_plane)
{
    constexpr std::uint64_t seed = 20304;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const glm::mat3 axes(glm::rotate(glm::mat4(1), random.uniform(0, 6), random.unit_vector()));
        const TexturePlane plane{random.in_cube(), axes[0], axes[1]};
        const glm::vec2 at(random.uniform(-2, 2), random.uniform(-2, 2));
        const glm::vec3 point =
            plane.origin + at.x * plane.u_axis + at.y * plane.v_axis + random.uniform(-2, 2) * axes[2];
        expect_near(planar_coordinates(point, plane), at, 4e-6F, "seed " + std::to_string(seed));
    }
}

TEST(Coordinates, grids_without_cells_are_refused)
{
    EXPECT_THROW((void)parametric_coordinates(0, 2), std::invalid_argument);
    EXPECT_THROW((void)parametric_coordinates(2, -1), std::invalid_argument);
}

// Each of a triangle's u is its corner's own, up to whole turns; the three lie within half a turn, and none below 0.
TEST(Coordinates, triangles_have_no_smear)
{
    constexpr std::uint64_t seed = 20305;
    Random random(seed);
    int across = 0;
    for (int i = 0; i < 20'000; ++i) {
        const float longitude = random.uniform(0, turn);
        std::array<glm::vec3, 3> corners{};
        for (glm::vec3& corner : corners) {
            const float angle = longitude + random.uniform(-0.24F, 0.24F) * turn;
            corner = {std::cos(angle), random.uniform(-2, 2), std::sin(angle)};
        }
        const std::array<glm::vec2, 3> at = spherical_triangle(corners);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec2 own = spherical_coordinates(corners[k]);
            ASSERT_EQ(at[k].y, own.y);
            ASSERT_TRUE(at[k].x == own.x || (at[k].x == own.x + 1 && own.x < 0.5F)) << "seed " << seed;
            across += at[k].x == own.x + 1 ? 1 : 0;
            ASSERT_LT(std::abs(at[k].x - at[(k + 1) % 3].x), 0.5F) << "seed " << seed << ", triangle " << i;
        }
    }
    EXPECT_GT(across, 1000);
}

TEST(Coordinates, corners_at_poles_take_the_mean)
{
    using Corners = std::array<glm::vec3, 3>;
    const glm::vec3 north(0, 1, 0);
    EXPECT_EQ(spherical_triangle(Corners{north, {1, 0, 0}, {0, 0, 1}})[0], glm::vec2(0.625F, 1));
    EXPECT_EQ(spherical_triangle(Corners{glm::vec3(0, 0, -1), north, {-1, 0, 0}})[1], glm::vec2(1.125F, 1))
        << "across the seam: 1.25 and 1";
    EXPECT_EQ(spherical_triangle(Corners{north, {0, 0, 1}, -north})[2], glm::vec2(0.75F, 0));
    EXPECT_EQ(spherical_triangle(Corners{north, north, -north})[1], glm::vec2(0.5F, 1));
}
