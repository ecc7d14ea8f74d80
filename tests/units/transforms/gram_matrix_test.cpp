#include <gtest/gtest.h>

#include <cmath>
#include <umbral/core/random.hpp>
#include <umbral/transforms/gram_matrix.hpp>

// Linked with the reference; what is expected comes from long double, in the world.

using namespace umbral;
using namespace umbral::transforms;

namespace {

constexpr std::uint64_t seed = 20281;
using Long = long double;
using LongVector = glm::vec<3, Long>;

LongVector in_world(const glm::mat3& basis, const glm::vec3& a)
{
    return Long{a.x} * LongVector(basis[0]) + Long{a.y} * LongVector(basis[1]) + Long{a.z} * LongVector(basis[2]);
}

/// No vector near the plane of the others; every other basis is left-handed.
glm::mat3 leaning_basis(Random& random, int i)
{
    glm::mat3 basis;
    for (int k = 0; k < 3; ++k) basis[k] = 0.5F * random.in_cube();
    basis = basis * 0.5F + glm::mat3(1);
    if (i % 2 == 1) std::swap(basis[1], basis[2]);
    return basis;
}

}

TEST(GramMatrix, worked_example)
{
    const glm::mat3 basis{{1, 0, 0}, {1, 1, 0}, {0, 0, 1}};
    const glm::mat3 gram{{1, 1, 0}, {1, 2, 0}, {0, 0, 1}};
    EXPECT_EQ(gram_matrix(basis), gram);
    EXPECT_EQ(dot_from_gram(gram, {1, 0, 0}, {0, 1, 0}), 1);
    EXPECT_EQ(area_from_gram(gram, {1, 0, 0}, {0, 1, 0}), 1);
    EXPECT_EQ(cross_in_basis(basis, {1, 0, 0}, {0, 1, 0}), glm::vec3(0, 0, 1));
    EXPECT_EQ(triple_product({1, 2, 3}, {0, 1, 4}, {5, 6, 0}), 1);
}

TEST(GramMatrix, products_from_coordinates_are_those_of_the_world)
{
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const glm::mat3 basis = leaning_basis(random, i);
        const glm::vec3 a = random.unit_vector();
        const glm::vec3 b =
            i % 3 == 0 ? a + std::pow(10.0F, random.uniform(-6, 0)) * random.unit_vector() : random.unit_vector();
        const LongVector u = in_world(basis, a);
        const LongVector v = in_world(basis, b);
        const LongVector product = glm::cross(u, v);
        ASSERT_NEAR(dot_from_gram(gram_matrix(basis), a, b), static_cast<double>(glm::dot(u, v)), 2e-6) << i;
        const LongVector back = in_world(basis, cross_in_basis(basis, a, b));
        const auto size = static_cast<double>(glm::length(product));
        ASSERT_LE(static_cast<double>(glm::length(back - product)), 2e-6 * size) << i;
        // The Gram matrix itself is rounded to float.
        ASSERT_NEAR(area_from_gram(gram_matrix(basis), a, b), size, 1e-5 * size) << i;
    }
}

TEST(GramMatrix, a_mirror_turns_cross_products_round_and_leaves_dot_products)
{
    Random random(seed + 1);
    for (int i = 0; i < 1000; ++i) {
        const glm::mat3 right = leaning_basis(random, 0);
        const glm::mat3 left(right[0] * glm::vec3(1, 1, -1), right[1] * glm::vec3(1, 1, -1),
                             right[2] * glm::vec3(1, 1, -1));
        const glm::vec3 a = random.in_cube();
        const glm::vec3 b = random.in_cube();
        ASSERT_EQ(gram_matrix(left), gram_matrix(right));
        ASSERT_EQ(cross_in_basis(left, a, b), -cross_in_basis(right, a, b));
    }
}

TEST(GramMatrix, cross_products_of_whole_numbers_are_perpendicular_exactly)
{
    constexpr int most = 1 << 20;
    EXPECT_EQ(triple_product({most, -most, most}, {most, most, -most}, {-most, most, most}), std::int64_t{4} << 60);
    Random random(seed + 2);
    const auto component = [&] { return static_cast<int>(random.below(2 * most + 1)) - most; };
    for (int i = 0; i < 20'000; ++i) {
        glm::ivec3 v[3];
        for (glm::ivec3& vector : v)
            for (int k = 0; k < 3; ++k) vector[k] = component();
        ASSERT_EQ(triple_product(v[0], v[1], v[0]), 0);
        ASSERT_EQ(triple_product(v[0], v[1], v[1]), 0);
        ASSERT_EQ(triple_product(v[0], v[1], v[2]), triple_product(v[1], v[2], v[0]));
        ASSERT_EQ(triple_product(v[0], v[1], v[2]), -triple_product(v[1], v[0], v[2]));
    }
}

TEST(GramMatrix, lengths_of_all_sizes)
{
    for (const float unit : {1e-7F, 1.0F, 1e7F}) {
        const glm::mat3 gram = gram_matrix(unit * glm::mat3(1));
        for (const float length : {1e-6F, 1e6F}) {
            const double side = double{unit} * double{length};
            EXPECT_NEAR(area_from_gram(gram, {length, 0, 0}, {0, length, 0}) / (side * side), 1, 1e-6);
        }
    }
}
