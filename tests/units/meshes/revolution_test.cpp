#include <gtest/gtest.h>

#include <meshes/revolution/profiles.hpp>
#include <umbral/meshes/revolution.hpp>

#include "../solution.hpp"

using namespace umbral;
using namespace umbral::meshes;

namespace {

using Revolve = TexturedMesh(std::span<const glm::vec2>, std::uint32_t);

/// Every test here holds for the reference and for the oracle.
class Revolution : public testing::TestWithParam<const char*> {
protected:
    Revolve* const revolve = tests::solution<Revolve>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, Revolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

double signed_volume(const IndexedMesh& mesh)
{
    double volume = 0;
    for (const glm::uvec3& t : mesh.triangles)
        volume += dot(glm::dvec3(mesh.positions[t.x]),
                      cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z]))) /
                  6;
    return volume;
}

}

TEST_P(Revolution, worked_numbers_of_the_statement)
{
    const TexturedMesh surface = revolve(Profile{{2, 0}, {2, 3}, {1, 3}}, 5);
    ASSERT_EQ(surface.mesh.positions.size(), 15U);
    ASSERT_EQ(surface.mesh.triangles.size(), 16U);
    EXPECT_EQ(surface.mesh.positions[3], glm::vec3(0, 0, -2));
    EXPECT_EQ(surface.normals[3], glm::vec3(0, 0, -1));
    EXPECT_EQ(surface.texture_coordinates[4], glm::vec2(0.25F, 0.75F));
    EXPECT_EQ(surface.normals[1], glm::vec3(std::sqrt(0.5F), std::sqrt(0.5F), 0));
    EXPECT_EQ(surface.mesh.triangles[0], glm::uvec3(0, 3, 4));
    EXPECT_EQ(surface.mesh.triangles[1], glm::uvec3(0, 4, 1));
}

TEST_P(Revolution, ball_is_closed_and_looks_outwards)
{
    const TexturedMesh ball = revolve(semicircle(65), 129);
    EXPECT_NEAR(signed_volume(ball.mesh), 4.18879, 0.01);
    EXPECT_EQ(ball.mesh.triangles.size(), 128U * (2 * 64 - 2));
    for (std::size_t i = 0; i < ball.normals.size(); ++i)
        EXPECT_GT(dot(ball.normals[i], ball.mesh.positions[i]), 0.999F);
    EXPECT_EQ(ball.normals[0], glm::vec3(0, -1, 0));
    EXPECT_EQ(ball.normals[64], glm::vec3(0, 1, 0));
}

// No triangle without area, and the seam has no crack: bit for bit.
TEST_P(Revolution, seam_and_degenerate_triangles)
{
    constexpr std::uint64_t seed = 20282;
    Random random(seed);
    for (int round = 0; round < 200; ++round) {
        const Profile profile = some_profile(random);
        const std::uint32_t copies = 4 + random.below(40);
        const TexturedMesh surface = revolve(profile, copies);
        const std::size_t last = surface.mesh.positions.size() - profile.size();
        for (std::size_t j = 0; j < profile.size(); ++j) {
            ASSERT_EQ(surface.mesh.positions[j], surface.mesh.positions[last + j]) << "seed " << seed;
            ASSERT_EQ(surface.normals[j], surface.normals[last + j]);
            ASSERT_EQ(surface.texture_coordinates[j].x, 0);
            ASSERT_EQ(surface.texture_coordinates[last + j], glm::vec2(1, surface.texture_coordinates[j].y));
        }
        for (const glm::uvec3& t : surface.mesh.triangles) {
            const auto at = [&](int k) { return surface.mesh.positions[t[k]]; };
            ASSERT_TRUE(at(0) != at(1) && at(1) != at(2) && at(2) != at(0));
        }
    }
}

TEST_P(Revolution, bad_profiles_are_refused)
{
    const std::vector<Attempt> all = attempts();
    for (std::size_t i = 0; i < all.size(); i += 2) {
        EXPECT_NO_THROW((void)revolve(all[i].profile, all[i].copies)) << i;
        EXPECT_THROW((void)revolve(all[i + 1].profile, all[i + 1].copies), std::invalid_argument) << i + 1;
    }
}

// The header's guarantee.
TEST(RevolutionAccuracy, reference_is_within_an_ulp)
{
    constexpr std::uint64_t seed = 20283;
    auto* const reference = tests::solution<Revolve>(REFERENCE_MODULE);
    auto* const oracle = tests::solution<Revolve>(ORACLE_MODULE);
    Random random(seed);
    const auto compare = [&](const Profile& profile, std::uint32_t copies) {
        const TexturedMesh got = reference(profile, copies);
        const TexturedMesh exact = oracle(profile, copies);
        ASSERT_EQ(got.mesh.triangles, exact.mesh.triangles);
        for (std::size_t i = 0; i < exact.mesh.positions.size(); ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                const float want = exact.mesh.positions[i][axis];
                ASSERT_LE(std::abs(got.mesh.positions[i][axis] - want), std::abs(want) * 0x1p-23F)
                    << "seed " << seed << ", vertex " << i;
                ASSERT_NEAR(got.normals[i][axis], exact.normals[i][axis], 1e-6);
            }
            for (int axis = 0; axis < 2; ++axis) {
                const float want = exact.texture_coordinates[i][axis];
                ASSERT_LE(std::abs(got.texture_coordinates[i][axis] - want), std::abs(want) * 0x1p-23F)
                    << "seed " << seed << ", vertex " << i;
            }
        }
    };
    for (int round = 0; round < 100; ++round) compare(some_profile(random), 4 + random.below(60));
    compare({{1, 0}, {2, 1}}, 20'001);
    compare(long_profile(20'000, random), 4);
}
