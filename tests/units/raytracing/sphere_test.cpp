#include <gtest/gtest.h>

#include <raytracing/support.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"

using namespace umbral;
using namespace umbral::raytracing;
using Intersect = std::optional<float>(const Ray&, const Sphere&);

namespace {

constexpr Sphere unit_ball{{0, 0, 0}, 1};

/// Every test here holds for the reference and for the oracle.
class SphereSolution : public testing::TestWithParam<const char*> {
protected:
    Intersect* const intersect = tests::solution<Intersect>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, SphereSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

}

// Worked by hand from |origin + t * direction - centre| = radius.
TEST_P(SphereSolution, known_answers)
{
    EXPECT_EQ(intersect({{0, 0, 5}, {0, 0, -1}}, unit_ball), 4.0F);
    EXPECT_EQ(intersect({{1, 2, 10}, {0, 0, -1}}, {{1, 2, 3}, 2}), 5.0F);
    EXPECT_EQ(intersect({{0, 0, 5}, {0, 0, -4}}, unit_ball), 1.0F);
    EXPECT_EQ(intersect({{0, 0, 0}, {0, 0, -1}}, unit_ball), 1.0F) << "from inside, the second root";
    EXPECT_EQ(intersect({{0, 0, 5}, {0, 0, 1}}, unit_ball), std::nullopt) << "behind";
    EXPECT_EQ(intersect({{0, 2, 5}, {0, 0, -1}}, unit_ball), std::nullopt);
    const std::optional<float> tangent = intersect({{1, 0, 5}, {0, 0, -1}}, unit_ball);
    ASSERT_TRUE(tangent.has_value());
    EXPECT_LE(tests::ulps_between(*tangent, 5), 2);
}

TEST_P(SphereSolution, interval_is_open)
{
    EXPECT_EQ(intersect({{0, 0, 5}, {0, 0, -1}, 4}, unit_ball), 6.0F);
    EXPECT_EQ(intersect({{0, 0, 5}, {0, 0, -1}, 3, 4}, unit_ball), std::nullopt);
    EXPECT_EQ(intersect({{0, 0, 5}, {0, 0, -1}, 4, 6}, unit_ball), std::nullopt);
    EXPECT_EQ(intersect({{0, 0, 5}, {0, 0, -1}, 7, 3}, unit_ball), std::nullopt) << "an empty interval";
    EXPECT_EQ(intersect({{0, 0, -5}, {0, 0, -1}, -endless, endless}, unit_ball), -6.0F)
        << "negative t count if the interval holds them";
}

TEST_P(SphereSolution, nonsense_hits_nothing)
{
    EXPECT_EQ(intersect({{0, 0, 5}, {0, 0, 0}}, unit_ball), std::nullopt);
    EXPECT_EQ(intersect({{not_a_number, 0, 5}, {0, 0, -1}}, unit_ball), std::nullopt);
    EXPECT_EQ(intersect({{0, 0, 5}, {0, not_a_number, -1}}, unit_ball), std::nullopt);
    EXPECT_EQ(intersect({{0, 0, 5}, {0, 0, -1}, not_a_number}, unit_ball), std::nullopt);
    EXPECT_EQ(intersect({{0, 0, endless}, {0, 0, -1}}, unit_ball), std::nullopt);
    EXPECT_EQ(intersect({{0, 0, 5}, {0, 0, -1}}, {{0, 0, 0}, not_a_number}), std::nullopt);
}

// The point found lies on the sphere, whatever formula found it.
TEST_P(SphereSolution, points_lie_on_the_sphere)
{
    constexpr std::uint64_t seed = 20261;
    RecordProperty("seed", std::to_string(seed));
    Random random(seed);
    const std::vector<BallShot> shots = random_pairs(random, 5000);
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const auto& [ray, ball] = shots[i];
        const std::optional<float> t = intersect(ray, ball);
        ASSERT_EQ(t.has_value(), miss_distance(shots[i]) < double{ball.radius}) << "seed " << seed << ", ray " << i;
        if (!t) continue;
        const glm::dvec3 point = glm::dvec3(ray.origin) + double{*t} * glm::dvec3(ray.direction);
        ASSERT_NEAR(length(point - glm::dvec3(ball.centre)) / double{ball.radius}, 1, 1e-5)
            << "seed " << seed << ", ray " << i;
    }
}

// The header's guarantee, at the distances and with the distribution of the statement's table.
TEST(SphereAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 20262;
    const auto reference = tests::solution<Intersect>(REFERENCE_MODULE);
    const auto oracle = tests::solution<Intersect>(ORACLE_MODULE);
    Random random(seed);
    for (const double distance : {2e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6}) {
        for (int i = 0; i < 20'000; ++i) {
            const Sphere ball{random.in_cube(), random.uniform(0.5F, 2)};
            BallShot shot = aimed(ball, distance, 1.3 * std::sqrt(random.uniform_double()), random);
            shot.ray.direction *= std::pow(10.0F, random.uniform(-6, 6));
            if (silhouette_margin(shot) <= 2) continue;
            const std::optional<float> got = reference(shot.ray, ball);
            const std::optional<float> exact = oracle(shot.ray, ball);
            ASSERT_EQ(got.has_value(), exact.has_value()) << "seed " << seed << ", " << distance << " radii, ray " << i;
            const double sine = miss_distance(shot) / double{ball.radius};
            if (!got || sine * sine > 0.99) continue;
            ASSERT_LE(tests::ulps_between(*got, *exact), 24)
                << "seed " << seed << ", " << distance << " radii, ray " << i;
        }
    }
}

// The hard cases must tell the forms apart: the school formula fails most of them.
TEST(SphereAccuracy, school_formula_fails_far_away)
{
    const auto naive = tests::solution<Intersect>(SCHOOL_FORMULA_MODULE);
    const auto oracle = tests::solution<Intersect>(ORACLE_MODULE);
    EXPECT_EQ(oracle({{0.5F, 0, 5000}}, unit_ball).value(), 4999.134F);
    EXPECT_EQ(naive({{0.5F, 0, 5000}}, unit_ball).value(), 5000.0F)
        << "b² and 4ac agree in all their digits: discriminant 0";
    Random random(20263);
    int right = 0;
    const std::vector<BallShot> shots = silhouette_pairs(random, 1e4, 1000, 3);
    for (const auto& [ray, ball] : shots) {
        const std::optional<float> got = naive(ray, ball);
        const std::optional<float> exact = oracle(ray, ball);
        right += got && exact && tests::ulps_between(*got, *exact) <= 16 ? 1 : 0;
    }
    EXPECT_LT(right, 100) << "of 1000 hits";
}

// The hard rays keep the distance from the silhouette that their band promises, at every distance the driver uses.
TEST(SphereInputs, silhouette_pairs_keep_their_margin)
{
    constexpr std::uint64_t seed = 20268;
    Random random(seed);
    for (const double distance : {1e2, 1e4, 1e6}) {
        const std::vector<BallShot> shots = silhouette_pairs(random, distance, 5000, 3);
        for (std::size_t i = 0; i < shots.size(); i += 2) {
            EXPECT_NE(miss_distance(shots[i]) < double{shots[i].ball.radius},
                      miss_distance(shots[i + 1]) < double{shots[i + 1].ball.radius});
            EXPECT_GE(silhouette_margin(shots[i]), 3) << "seed " << seed << ", ray " << i;
            EXPECT_GE(silhouette_margin(shots[i + 1]), 3) << "seed " << seed << ", ray " << i + 1;
        }
        if (HasFailure()) return;
    }
}
