#include <gtest/gtest.h>

#include <raytracing/triangle/shots.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"

using namespace umbral;
using namespace umbral::raytracing;
using Intersect = std::optional<TriangleHit>(const Ray&, const Triangle&);

namespace {

constexpr Triangle unit_triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/// Every test here holds for the reference and for the oracle.
class TriangleSolution : public testing::TestWithParam<const char*> {
protected:
    Intersect* const intersect = tests::solution<Intersect>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, TriangleSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

/// How many of the rays at corners and points of edges hit none of the triangles round an icosphere at `centre`.
int lost_rays(Intersect* intersect, const glm::vec3& centre, std::uint64_t seed, int rays)
{
    const shapes::Shape ball = shapes::icosphere(2);
    std::vector<Triangle> mesh;
    const auto place = [&](std::size_t i) { return centre + 2.0F * ball.positions[ball.indices[i]]; };
    for (std::size_t i = 0; i < ball.indices.size(); i += 3) mesh.push_back({place(i), place(i + 1), place(i + 2)});
    Random random(seed);
    int lost = 0;
    for (int i = 0; i < rays; ++i) {
        const Triangle& triangle = mesh[random.below(static_cast<std::uint32_t>(mesh.size()))];
        const double along = i % 2 == 0 ? 0 : random.uniform_double();
        const glm::dvec3 target = glm::mix(glm::dvec3(triangle.v0), glm::dvec3(triangle.v1), along);
        const glm::vec3 origin = centre + 0.5F * random.in_cube();
        const Ray ray{origin, glm::vec3(normalize(target - glm::dvec3(origin)))};
        bool hit = false;
        for (const Triangle& one : mesh) hit = hit || intersect(ray, one).has_value();
        lost += hit ? 0 : 1;
    }
    return lost;
}

}

// Worked by hand; the first two are the course's.
TEST_P(TriangleSolution, known_answers)
{
    const std::optional<TriangleHit> hit = intersect({{0.25F, 0.25F, 5}, {0, 0, -1}}, unit_triangle);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->t, 5);
    EXPECT_EQ(hit->a, 0.25F);
    EXPECT_EQ(hit->b, 0.25F);
    EXPECT_FALSE(intersect({{0.6F, 0.6F, 5}, {0, 0, -1}}, unit_triangle)) << "a + b = 1.2";
    EXPECT_EQ(intersect({{0.25F, 0.5F, -5}, {0, 0, 2}}, unit_triangle)->t, 2.5F) << "from behind";
    EXPECT_FALSE(intersect({{0.25F, 0.25F, 5}, {0, 0, 1}}, unit_triangle)) << "behind the origin";
    EXPECT_FALSE(intersect({{0.25F, 0.25F, 5}, {0, 0, -1}, 5}, unit_triangle)) << "at t_min";
    EXPECT_FALSE(intersect({{0.25F, 0.25F, 5}, {0, 0, -1}, 0, 5}, unit_triangle)) << "at t_max";
    EXPECT_EQ(intersect({{0.25F, 0.25F, -5}, {0, 0, -1}, -endless}, unit_triangle)->t, -5);
}

TEST_P(TriangleSolution, edges_and_corners_belong_to_it)
{
    for (const glm::vec2 on : {glm::vec2(0, 0), {1, 0}, {0, 1}, {0.5F, 0.5F}, {0, 0.25F}, {0.75F, 0}})
        EXPECT_TRUE(intersect({{on, 3}, {0, 0, -1}}, unit_triangle)) << on.x << ' ' << on.y;
}

TEST_P(TriangleSolution, nonsense_hits_nothing)
{
    EXPECT_FALSE(intersect({{-1, 0.25F, 0}, {1, 0, 0}}, unit_triangle)) << "in the plane";
    EXPECT_FALSE(intersect({{0.25F, 0.25F, 1}, {1, 0, 0}}, unit_triangle)) << "parallel";
    EXPECT_FALSE(intersect({{0.25F, 0.25F, 1}, {0, 0, 0}}, unit_triangle));
    EXPECT_FALSE(intersect({{0.5F, 0, 1}, {0, 0, -1}}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}})) << "without area";
    EXPECT_FALSE(intersect({{0, 0, 1}, {0, 0, -1}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}})) << "a point";
    for (int axis = 0; axis < 3; ++axis) {
        Ray ray{{0.25F, 0.25F, 5}, {0, 0, -1}};
        ray.origin[axis] = not_a_number;
        EXPECT_FALSE(intersect(ray, unit_triangle));
        ray = {{0.25F, 0.25F, 5}, {0, 0, -1}};
        ray.direction[axis] = not_a_number;
        EXPECT_FALSE(intersect(ray, unit_triangle));
    }
    EXPECT_FALSE(intersect({{0.25F, 0.25F, 5}, {0, 0, -1}, not_a_number}, unit_triangle));
}

// Both sides of the equation are the same point, and the twin of each hit misses.
TEST_P(TriangleSolution, ray_and_weights_give_the_same_point)
{
    constexpr std::uint64_t seed = 42001;
    Random random(seed);
    const std::vector<TriangleShot> shots = random_pairs(random, 3000, 0.2, 1, 0.01);
    for (std::size_t i = 0; i < shots.size(); i += 2) {
        const std::optional<TriangleHit> one = intersect(shots[i].ray, shots[i].triangle);
        const std::optional<TriangleHit> other = intersect(shots[i + 1].ray, shots[i + 1].triangle);
        ASSERT_NE(one.has_value(), other.has_value()) << "seed " << seed << ", pair " << i / 2;
        const auto& [ray, triangle] = one ? shots[i] : shots[i + 1];
        const TriangleHit hit = one ? *one : *other;
        const glm::dvec3 along = glm::dvec3(ray.origin) + double{hit.t} * glm::dvec3(ray.direction);
        ASSERT_LT(distance(along, point_of(triangle, hit.a, hit.b)), 3e-6) << "seed " << seed << ", pair " << i / 2;
    }
}

// No ray from inside a closed mesh gets out, also far from the world's origin.
TEST_P(TriangleSolution, no_ray_is_lost_between_triangles)
{
    EXPECT_EQ(lost_rays(intersect, {0, 0, 0}, 42002, 1000), 0);
    EXPECT_EQ(lost_rays(intersect, {14837, 1234, -22342}, 42003, 1000), 0);
}

TEST(TriangleAccuracy, float_loses_rays_between_triangles)
{
    const auto in_float = tests::solution<Intersect>(IN_FLOAT_MODULE);
    const int lost = lost_rays(in_float, {0, 0, 0}, 42002, 1000);
    RecordProperty("lost", lost);
    EXPECT_GT(lost, 20) << "of 1000";
}

TEST(TriangleAccuracy, reference_agrees_with_the_oracle)
{
    constexpr std::uint64_t seed = 42004;
    const auto reference = tests::solution<Intersect>(REFERENCE_MODULE);
    const auto oracle = tests::solution<Intersect>(ORACLE_MODULE);
    Random random(seed);
    const std::vector<TriangleShot> shots = random_pairs(random, 20'000, 1e-4, 1, 0.001);
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const std::optional<TriangleHit> got = reference(shots[i].ray, shots[i].triangle);
        const std::optional<TriangleHit> exact = oracle(shots[i].ray, shots[i].triangle);
        ASSERT_EQ(got.has_value(), exact.has_value()) << "seed " << seed << ", ray " << i;
        if (!got) continue;
        ASSERT_LE(tests::ulps_between(got->t, exact->t), 1) << "seed " << seed << ", ray " << i;
        ASSERT_NEAR(got->a, exact->a, 1e-7) << "seed " << seed << ", ray " << i;
        ASSERT_NEAR(got->b, exact->b, 1e-7) << "seed " << seed << ", ray " << i;
    }
}
