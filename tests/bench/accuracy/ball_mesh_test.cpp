#include <gtest/gtest.h>

#include <bench/accuracy/ball_mesh.hpp>
#include <cmath>

namespace umbral::bench {
namespace {

constexpr double pi = 3.141592653589793;
const glm::dvec3 sideways(1, 0, 0);

// Four sectors and two rings: an octahedron. Faces lie at 1/√3, their normals at that cosine from the corners; the
// outline is a square.
TEST(BallMesh, is_the_octahedron_at_its_coarsest)
{
    const BallMesh mesh = ball_mesh(4, 2);
    EXPECT_EQ(mesh.positions.size(), 6U);
    EXPECT_EQ(mesh.indices.size(), 8U * 3);
    const BallErrors errors = errors_of(mesh, sideways);
    EXPECT_NEAR(errors.distance, 1 - 1 / std::sqrt(3.0), 1e-6);
    EXPECT_NEAR(errors.angle, std::acos(1 / std::sqrt(3.0)), 1e-6);
    EXPECT_NEAR(errors.silhouette, 1 - std::sqrt(0.5), 1e-6);
}

// Seen from a pole the outline is the equator, a regular polygon: 1 - cos(π/n), known in advance.
TEST(BallMesh, outline_from_the_pole_is_the_equators)
{
    for (const int sectors : {4, 12, 64})
        EXPECT_NEAR(errors_of(ball_mesh(sectors, 8), {0, 0, 1}).silhouette, 1 - std::cos(pi / sectors), 2e-7)
            << sectors;
}

// From the side, with a multiple of four sectors, it is a meridian: a polygon of 2 * rings sides.
TEST(BallMesh, outline_from_the_side_is_a_meridians)
{
    for (const int rings : {4, 10, 32})
        EXPECT_NEAR(errors_of(ball_mesh(64, rings), sideways).silhouette, 1 - std::cos(pi / (2 * rings)), 2e-7)
            << rings;
}

TEST(BallMesh, turns_outwards_and_closes)
{
    const BallMesh mesh = ball_mesh(10, 7);
    // Euler: corners - edges + faces = 2, with three half-edges a face.
    const std::size_t faces = mesh.indices.size() / 3;
    EXPECT_EQ(mesh.positions.size() + faces - 3 * faces / 2, 2U);
    double volume = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        const glm::dvec3 b = mesh.positions[mesh.indices[i + 1]];
        const glm::dvec3 c = mesh.positions[mesh.indices[i + 2]];
        const double part = dot(a, cross(b, c)) / 6;
        EXPECT_GT(part, 0) << i / 3;
        volume += part;
    }
    EXPECT_GT(volume, 0.8 * 4 * pi / 3);
    EXPECT_LT(volume, 4 * pi / 3);
}

TEST(BallMesh, every_error_falls_as_the_mesh_is_refined)
{
    BallErrors before{1, pi, 1};
    for (int rings = 4; rings <= 256; rings *= 2) {
        const BallErrors errors = errors_of(ball_mesh(2 * rings, rings), normalize(glm::dvec3(0.83, -0.31, 0.59)));
        EXPECT_LT(errors.distance, before.distance) << rings;
        EXPECT_LT(errors.angle, before.angle) << rings;
        EXPECT_LT(errors.silhouette, before.silhouette) << rings;
        // Second order for places, first order for normals.
        if (rings >= 16) {
            EXPECT_NEAR(errors.distance / before.distance, 0.25, 0.02) << rings;
            EXPECT_NEAR(errors.angle / before.angle, 0.5, 0.05) << rings;
        }
        before = errors;
    }
}

}
}
