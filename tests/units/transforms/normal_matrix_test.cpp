#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>
#include <umbral/transforms/normal_matrix.hpp>

// Linked with the reference; what is expected follows from what a normal is: perpendicular to the transformed tangents,
// on the outer side.

using namespace umbral;
using namespace umbral::transforms;

namespace {

glm::mat4 any_matrix(Random& random)
{
    glm::mat4 matrix(1);
    for (int column = 0; column < 3; ++column) matrix[column] = glm::vec4(random.in_cube(), 0);
    matrix[3] = glm::vec4(10.0F * random.in_cube(), 1);
    return matrix;
}

}

TEST(NormalMatrix, known_answers)
{
    const glm::mat4 stretched = glm::scale(glm::translate(glm::mat4(1), {3, 4, 5}), {2, 1, 1});
    EXPECT_EQ(normal_matrix(stretched), glm::mat3(0.5F, 0, 0, 0, 1, 0, 0, 0, 1));
    const glm::vec3 n = transformed_normal(stretched, glm::normalize(glm::vec3(1, 1, 0)));
    EXPECT_NEAR(n.x, std::sqrt(0.2), 1e-7);
    EXPECT_NEAR(n.y, std::sqrt(0.8), 1e-7);
    EXPECT_EQ(transformed_normal(glm::scale(glm::mat4(1), {1, 1, -1}), {0, 0, 1}), glm::vec3(0, 0, -1));
}

TEST(NormalMatrix, perpendicular_and_outwards)
{
    constexpr std::uint64_t seed = 20281;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const float size = std::pow(10.0F, random.uniform(-36, 36));
        const glm::mat4 model = any_matrix(random) * glm::scale(glm::mat4(1), glm::vec3(size));
        const glm::vec3 normal = random.unit_vector();
        const glm::dmat3 a = glm::dmat3(glm::mat3(model)) / double{size};
        const glm::dvec3 got(transformed_normal(model, normal));
        ASSERT_NEAR(length(got), 1, 2e-7) << "seed " << seed << ", matrix " << i;
        const glm::dvec3 tangent = cross(glm::dvec3(normal), glm::dvec3(random.unit_vector()));
        ASSERT_LE(std::abs(dot(got, a * tangent)), 2e-7 * (length(a[0]) + length(a[1]) + length(a[2])))
            << "seed " << seed << ", matrix " << i;
        ASSERT_GE(dot(got, a * glm::dvec3(normal)), -1e-6) << "seed " << seed << ", matrix " << i;
        ASSERT_LE(length(cross(got, glm::dmat3(normal_matrix(model)) * glm::dvec3(normal))), 4e-7)
            << "seed " << seed << ", matrix " << i;
    }
}

TEST(NormalMatrix, flattened_matrices)
{
    EXPECT_EQ(transformed_normal(glm::scale(glm::mat4(1), {2, 0, 3}), {0.6F, 0.8F, 0}), glm::vec3(0, 1, 0));
    EXPECT_EQ(transformed_normal(glm::scale(glm::mat4(1), {-2, 0, 3}), {0, 1, 0}), glm::vec3(0, -1, 0))
        << "the cofactors' sign, since there is no inverse";
    EXPECT_EQ(transformed_normal(glm::scale(glm::mat4(1), {2, 0, 3}), {1, 0, 0}), glm::vec3(0)) << "edge-on";
    EXPECT_EQ(normal_matrix(glm::scale(glm::mat4(1), {0, 0, 3})), glm::mat3(0));
    EXPECT_EQ(transformed_normal(glm::scale(glm::mat4(1), {0, 0, 3}), {0, 0, 1}), glm::vec3(0));
    EXPECT_EQ(transformed_normal(glm::mat4(1), glm::vec3(0)), glm::vec3(0));
}
