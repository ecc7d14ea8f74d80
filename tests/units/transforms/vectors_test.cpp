#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <umbral/core/random.hpp>
#include <umbral/transforms/vectors.hpp>

#include "../ulps.hpp"

// Linked with the reference; what is expected comes from long double, by other formulas.

using namespace umbral;
using namespace umbral::transforms;

namespace {

constexpr std::uint64_t seed = 20271;
using Long = long double;

Long dot(const glm::vec3& a, const glm::vec3& b)
{
    return Long{a.x} * Long{b.x} + Long{a.y} * Long{b.y} + Long{a.z} * Long{b.z};
}
Long size(const glm::vec3& v) { return std::hypot(Long{v.x}, Long{v.y}, Long{v.z}); }

glm::vec3 any_size(Random& random) { return std::pow(10.0F, random.uniform(-37, 37)) * random.unit_vector(); }

}

TEST(Vectors, known_answers)
{
    EXPECT_EQ(dot_product({1, 2, 2}, {3, 0, 4}), 11);
    EXPECT_EQ(cross_product({1, 2, 2}, {3, 0, 4}), glm::vec3(8, 2, -6));
    EXPECT_EQ(length_of({2, 3, 6}), 7);
    EXPECT_EQ(parallel_part({1, 2, 2}, {3, 0, 4}), glm::vec3(1.32F, 0, 1.76F));
    EXPECT_EQ(angle_between({1, 0, 0}, {-2, 0, 0}), 3.14159274F);
    EXPECT_EQ(perpendicular_part({1, 2, 3}, {-2, -4, -6}), glm::vec3(0));
}

TEST(Vectors, lengths_of_all_sizes)
{
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 v = any_size(random);
        ASSERT_LE(tests::ulps_between(length_of(v), static_cast<float>(size(v))), 1)
            << "seed " << seed << ", vector " << i;
        ASSERT_NEAR(static_cast<double>(size(normalised(v))), 1, 1e-7) << "seed " << seed << ", vector " << i;
    }
    EXPECT_EQ(length_of({0, std::numeric_limits<float>::denorm_min(), 0}), std::numeric_limits<float>::denorm_min());
}

// tan(α/2) = |u - v| / |u + v| for unit u and v: nothing is near its turning point.
TEST(Vectors, angles_within_an_ulp)
{
    Random random(seed + 1);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 a = any_size(random);
        const glm::vec3 b = any_size(random);
        Long difference = 0;
        Long sum = 0;
        for (int k = 0; k < 3; ++k) {
            const Long u = Long{a[k]} / size(a);
            const Long v = Long{b[k]} / size(b);
            difference += (u - v) * (u - v);
            sum += (u + v) * (u + v);
        }
        const auto expected = static_cast<float>(2 * std::atan2(std::sqrt(difference), std::sqrt(sum)));
        ASSERT_LE(tests::ulps_between(angle_between(a, b), expected), 1) << "seed " << seed + 1 << ", vectors " << i;
    }
    // Small angles in the plane, where they are known.
    for (const float tangent : {1e-3F, 1e-6F, 1e-20F, 1e-38F})
        EXPECT_LE(tests::ulps_between(angle_between({1, 0, 0}, {1, tangent, 0}), std::atan(tangent)), 1);
}

TEST(Vectors, parts_add_up_and_are_perpendicular)
{
    Random random(seed + 2);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 a = random.unit_vector();
        const glm::vec3 b =
            std::pow(10.0F, random.uniform(-37, 37)) *
            (i % 2 == 0 ? random.unit_vector() : a + std::pow(10.0F, random.uniform(-6, 0)) * random.unit_vector());
        const glm::vec3 along = parallel_part(a, b);
        const glm::vec3 across = perpendicular_part(a, b);
        ASSERT_LE(static_cast<double>(size(a - along - across)), 4e-7) << "seed " << seed + 2 << ", vectors " << i;
        ASSERT_LE(static_cast<double>(std::abs(dot(across, b))), 2e-7 * static_cast<double>(size(across) * size(b)))
            << "seed " << seed + 2 << ", vectors " << i;
        const glm::vec3 normal = cross_product(a, glm::vec3(glm::dvec3(b) / static_cast<double>(size(b))));
        ASSERT_LE(static_cast<double>(std::abs(dot(normal, a))), 2e-7 * static_cast<double>(size(normal)))
            << "seed " << seed + 2 << ", vectors " << i;
    }
}

TEST(Vectors, null_vectors)
{
    const glm::vec3 a(1, -2, 3);
    for (const glm::vec3& null : {glm::vec3(0), glm::vec3(0, -0.0F, 0)}) {
        EXPECT_EQ(normalised(null), glm::vec3(0));
        EXPECT_EQ(angle_between(a, null), 0);
        EXPECT_EQ(angle_between(null, a), 0);
        EXPECT_EQ(parallel_part(a, null), glm::vec3(0));
        EXPECT_EQ(perpendicular_part(a, null), a);
    }
}

// The statement's figures: what the arc cosine gives in float.
TEST(Vectors, arc_cosine_loses_small_angles)
{
    const auto by_arc_cosine = [](float angle) { return std::acos(std::cos(angle)); };
    EXPECT_NEAR(by_arc_cosine(3e-4F), 3.45e-4, 1e-6);
    EXPECT_EQ(by_arc_cosine(1e-4F), 0);
    Random random(seed + 3);
    int over_one = 0;
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 v = random.in_cube();
        const glm::vec3 u = v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
        if (u.x * u.x + u.y * u.y + u.z * u.z > 1) ++over_one;
    }
    EXPECT_NEAR(over_one / 20'000.0, 0.2, 0.06) << "seed " << seed + 3;
}
