#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <umbral/core/random.hpp>
#include <umbral/transforms/about_a_point.hpp>

// Linked with the reference; what is expected are the properties that name each transformation, in double.

using namespace umbral;
using namespace umbral::transforms;

namespace {

glm::dvec3 image(const glm::mat4& m, const glm::dvec3& p) { return glm::dvec3(glm::dmat4(m) * glm::dvec4(p, 1)); }

/// The largest entry of MᵀM - I.
double off_orthonormal(const glm::mat4& matrix)
{
    const glm::dmat3 m{glm::mat3(matrix)};
    const glm::dmat3 rest = transpose(m) * m - glm::dmat3(1);
    double worst = 0;
    for (int i = 0; i < 9; ++i) worst = std::max(worst, std::abs(rest[i / 3][i % 3]));
    return worst;
}

}

TEST(AboutAPoint, known_answers)
{
    EXPECT_EQ(reflection_in_plane({1, 2, 3}, {0, 0, 2}) * glm::vec4(5, 6, 7, 1), glm::vec4(5, 6, -1, 1));
    EXPECT_EQ(reflection_in_point({1, 2, 3}) * glm::vec4(5, 6, 7, 1), glm::vec4(-3, -2, -1, 1));
    EXPECT_EQ(scaling_about_point({1, 2, 3}, {2, 0, 1}) * glm::vec4(5, 6, 7, 1), glm::vec4(9, 2, 7, 1));
    EXPECT_EQ(scaling_along({1, 2, 3}, {0, 0, 2}, 3) * glm::vec4(5, 6, 7, 1), glm::vec4(5, 6, 15, 1));
    EXPECT_EQ(scaling_along({1, 2, 3}, {0, 0, 2}, -1), reflection_in_plane({1, 2, 3}, {0, 0, 2}));
    EXPECT_EQ(scaling_along({1, 2, 3}, {0, 0, 0}, 3), glm::mat4(1));
    EXPECT_EQ(alignment({1, 0, 0}, {-3, 0, 0}), glm::mat4(glm::mat3(-1, 0, 0, 0, -1, 0, 0, 0, 1)));
    EXPECT_EQ(placed_along({1, 2, 3}, {0, -2, 0})[0], glm::vec4(1, 0, 0, 0));
    EXPECT_EQ(placed_along({1, 2, 3}, {0, 0, 0})[3], glm::vec4(1, 2, 3, 1));
}

TEST(AboutAPoint, centres_stay_and_distances_too)
{
    constexpr std::uint64_t seed = 20311;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const glm::vec3 centre = 5.0F * random.in_cube();
        const glm::vec3 direction = std::pow(10.0F, random.uniform(-37, 37)) * random.unit_vector();
        const glm::mat4 turn = rotation_about_point(centre, {direction, random.uniform(-9, 9)});
        const glm::mat4 line = reflection_in_line(centre, direction);
        const glm::mat4 plane = reflection_in_plane(centre, direction);
        for (const glm::mat4& m : {turn, line, plane}) {
            ASSERT_LE(length(image(m, glm::dvec3(centre)) - glm::dvec3(centre)), 4e-6)
                << "seed " << seed << ", number " << i;
            ASSERT_LE(off_orthonormal(m), 4e-7) << "seed " << seed << ", number " << i;
        }
        ASSERT_NEAR(glm::determinant(glm::dmat3(glm::mat3(line))), 1, 1e-6);
        ASSERT_NEAR(glm::determinant(glm::dmat3(glm::mat3(plane))), -1, 1e-6);
        const glm::dvec3 e = normalize(glm::dvec3(direction));
        ASSERT_LE(length(image(line, glm::dvec3(centre) + e) - glm::dvec3(centre) - e), 4e-6)
            << "seed " << seed << ", number " << i;
        ASSERT_LE(length(image(plane, glm::dvec3(centre) + e) - glm::dvec3(centre) + e), 4e-6)
            << "seed " << seed << ", number " << i;
    }
}

// It takes one to the other, and leaves what is perpendicular to both: also where they are nearly equal or opposite.
TEST(AboutAPoint, alignment_is_the_shortest_turn)
{
    constexpr std::uint64_t seed = 20312;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 from = random.unit_vector();
        const glm::vec3 near = from + std::pow(10.0F, random.uniform(-6, 1)) * random.unit_vector();
        const glm::vec3 to = i % 2 == 0 ? near : -near;
        const glm::mat4 m = alignment(from, to);
        ASSERT_LE(off_orthonormal(m), 4e-7) << "seed " << seed << ", number " << i;
        ASSERT_LE(length(image(m, normalize(glm::dvec3(from))) - normalize(glm::dvec3(to))), 2e-7)
            << "seed " << seed << ", number " << i;
        const glm::dvec3 normal = cross(glm::dvec3(from), glm::dvec3(to));
        if (normal == glm::dvec3(0)) continue;
        ASSERT_LE(length(image(m, normalize(normal)) - normalize(normal)), 2e-7) << "seed " << seed << ", number " << i;
    }
}

TEST(AboutAPoint, placed_objects_stand_upright)
{
    constexpr std::uint64_t seed = 20313;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const float aside = std::pow(10.0F, random.uniform(-37, 0));
        const glm::vec3 direction(aside * random.uniform(-1, 1), 1, aside * random.uniform(0.1F, 1));
        const glm::mat4 m = placed_along({0, 0, 0}, direction);
        ASSERT_LE(off_orthonormal(m), 4e-7) << "seed " << seed << ", number " << i;
        ASSERT_EQ(m[0].y, 0) << "seed " << seed << ", number " << i;
        ASSERT_LE(length(glm::dvec3(m[2]) - normalize(glm::dvec3(direction))), 2e-7)
            << "seed " << seed << ", number " << i;
        ASSERT_GT(glm::determinant(glm::mat3(m)), 0.99F);
    }
}

TEST(AboutAPoint, null_directions_change_nothing)
{
    const glm::vec3 null(0, -0.0F, 0);
    EXPECT_EQ(reflection_in_line({1, 2, 3}, null), glm::mat4(1));
    EXPECT_EQ(reflection_in_plane({1, 2, 3}, null), glm::mat4(1));
    EXPECT_EQ(alignment(null, {1, 0, 0}), glm::mat4(1));
    EXPECT_EQ(alignment({1, 0, 0}, null), glm::mat4(1));
    EXPECT_EQ(rotation_about_point({1, 2, 3}, {{0, 0, 1}, std::numeric_limits<float>::infinity()}), glm::mat4(1));
}
