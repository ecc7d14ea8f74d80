#include <gtest/gtest.h>

#include <glm/gtx/intersect.hpp>
#include <raytracing/disc/shots.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"

using namespace umbral;
using namespace umbral::raytracing;
using Intersect = std::optional<float>(const Ray&, const Disc&);

namespace {

constexpr Disc unit_disc{{0, 0, 0}, {0, 0, 1}, 1};

/// Every test here holds for the reference and for the oracle.
class DiscSolution : public testing::TestWithParam<const char*> {
protected:
    Intersect* const intersect = tests::solution<Intersect>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Solutions, DiscSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

}

// Worked by hand; the first is the course's.
TEST_P(DiscSolution, known_answers)
{
    EXPECT_EQ(intersect({{0.5F, 0, 3}, {0, 0, -1}}, unit_disc), 3.0F);
    EXPECT_EQ(intersect({{0.5F, 0, 3}, {0, 0, -1}}, {{0, 0, 0}, {0, 0, 7}, 1}), 3.0F);
    EXPECT_EQ(intersect({{0.5F, 0, 3}, {0, 0, -1}}, {{0, 0, 0}, {0, 0, -1}, 1}), 3.0F);
    EXPECT_EQ(intersect({{0.5F, 0, 3}, {0, 0, -2}}, unit_disc), 1.5F);
    EXPECT_EQ(intersect({{0.5F, 0, -3}, {0, 0, 1}}, unit_disc), 3.0F) << "from below";
    EXPECT_EQ(intersect({{4, 0, 0}, {-1, 0, 0}}, {{0, 0, 0}, {1, 1, 0}, 3}), 4.0F) << "a disc that leans";
    EXPECT_EQ(intersect({{0.5F, 0, 3}, {0, 0, 1}}, unit_disc), std::nullopt) << "behind";
    EXPECT_EQ(intersect({{1.5F, 0, 3}, {0, 0, -1}}, unit_disc), std::nullopt) << "beside";
}

TEST_P(DiscSolution, the_rim_does_not_belong_to_the_disc)
{
    EXPECT_EQ(intersect({{1, 0, 3}, {0, 0, -1}}, unit_disc), std::nullopt);
    EXPECT_EQ(intersect({{3, 4, 3}, {0, 0, -1}}, {{0, 0, 0}, {0, 0, 1}, 5}), std::nullopt);
    EXPECT_EQ(intersect({{std::nextafter(1.0F, 0.0F), 0, 3}, {0, 0, -1}}, unit_disc), 3.0F);
}

TEST_P(DiscSolution, interval_is_open)
{
    EXPECT_EQ(intersect({{0, 0, 3}, {0, 0, -1}, 3}, unit_disc), std::nullopt);
    EXPECT_EQ(intersect({{0, 0, 3}, {0, 0, -1}, 0, 3}, unit_disc), std::nullopt);
    EXPECT_EQ(intersect({{0, 0, 3}, {0, 0, -1}, 2.75F, 3.25F}, unit_disc), 3.0F);
    EXPECT_EQ(intersect({{0, 0, 0}, {0, 0, -1}}, unit_disc), std::nullopt) << "begins on the disc";
    EXPECT_EQ(intersect({{0, 0, -3}, {0, 0, -1}, -endless}, unit_disc), -3.0F);
}

// What is rounded is what the interval holds: no t is returned that lies outside.
TEST_P(DiscSolution, no_distance_is_rounded_out_of_the_interval)
{
    const Disc leaning{{0, 0, 0}, {3, 0, 7}, 1};
    const std::optional<float> t = intersect({{0.125F, 0, 1}, {0, 0, -1}}, leaning);
    ASSERT_TRUE(t.has_value());
    EXPECT_EQ(intersect({{0.125F, 0, 1}, {0, 0, -1}, 0, *t}, leaning), std::nullopt);
    EXPECT_EQ(intersect({{0.125F, 0, 1}, {0, 0, -1}, *t}, leaning), std::nullopt);
}

TEST_P(DiscSolution, nonsense_hits_nothing)
{
    EXPECT_EQ(intersect({{0, 0, 3}, {0, 0, 0}}, unit_disc), std::nullopt);
    EXPECT_EQ(intersect({{0, 0, 3}, {0, 0, -1}}, {{0, 0, 0}, {0, 0, 0}, 1}), std::nullopt);
    EXPECT_EQ(intersect({{-2, 0, 0}, {1, 0, 0}}, unit_disc), std::nullopt) << "in the plane";
    EXPECT_EQ(intersect({{-2, 0, 0}, {1, 0, 0}, -endless}, unit_disc), std::nullopt) << "in the plane";
    EXPECT_EQ(intersect({{0, 0, 3}, {1, 0, 0}}, unit_disc), std::nullopt) << "parallel";
    for (int axis = 0; axis < 3; ++axis) {
        Ray ray{{0, 0, 3}, {0, 0, -1}};
        ray.origin[axis] = not_a_number;
        EXPECT_EQ(intersect(ray, unit_disc), std::nullopt);
        ray = {{0, 0, 3}, {0, 0, -1}};
        ray.direction[axis] = not_a_number;
        EXPECT_EQ(intersect(ray, unit_disc), std::nullopt);
    }
    EXPECT_EQ(intersect({{0, 0, 3}, {0, 0, -1}, not_a_number}, unit_disc), std::nullopt);
    EXPECT_EQ(intersect({{0, 0, 3}, {0, 0, -1}, 0, not_a_number}, unit_disc), std::nullopt);
    EXPECT_EQ(intersect({{0, 0, endless}, {0, 0, -1}}, unit_disc), std::nullopt);
}

// GLM's ray and plane, in double, wants the normal against the ray.
TEST_P(DiscSolution, agrees_with_glm)
{
    constexpr std::uint64_t seed = 51001;
    Random random(seed);
    const std::vector<DiscShot> shots = random_pairs(random, 3000);
    for (std::size_t i = 0; i < shots.size(); ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", ray " + std::to_string(i));
        const auto& [ray, disc] = shots[i];
        const glm::dvec3 origin(ray.origin);
        const glm::dvec3 direction(ray.direction);
        const glm::dvec3 centre(disc.centre);
        glm::dvec3 normal = normalize(glm::dvec3(disc.normal));
        if (dot(normal, direction) > 0) normal = -normal;
        double t = 0;
        ASSERT_TRUE(glm::intersectRayPlane(origin, direction, centre, normal, t));
        const std::optional<float> got = intersect(ray, disc);
        ASSERT_EQ(got.has_value(), distance(origin + t * direction, centre) < double{disc.radius});
        if (got) {
            ASSERT_LE(tests::ulps_between(*got, static_cast<float>(t)), 1);
        }
    }
}

// The inputs are what their names say.
TEST(DiscInputs, pairs_are_a_hit_and_a_miss)
{
    const std::uint64_t seed = 51002;
    Random random(seed);
    const auto expect_pairs = [seed](const std::vector<DiscShot>& shots, double margin) {
        for (std::size_t i = 0; i < shots.size(); i += 2) {
            const double one = depth_inside_rim(shots[i]);
            const double other = depth_inside_rim(shots[i + 1]);
            ASSERT_LT(one * other, 0) << "seed " << seed << ", pair " << i / 2;
            ASSERT_GT(std::min(std::abs(one), std::abs(other)), margin) << "seed " << seed << ", pair " << i / 2;
        }
    };
    expect_pairs(random_pairs(random, 3000), 0.0099);
    expect_pairs(grazing_pairs(random, 3000), 0.15);
    for (const float away : {1e4F, 1e5F, 1e6F}) expect_pairs(remote_pairs(random, away, 3000), 1.9e-4);
}

// The header's guarantee.
TEST(DiscAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 51003;
    const auto reference = tests::solution<Intersect>(REFERENCE_MODULE);
    const auto oracle = tests::solution<Intersect>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 100'000; ++i) {
        Disc disc = random_disc(random);
        disc.centre *= std::pow(10.0F, random.uniform(-3, 5));
        const double sine = std::pow(10.0, -6 * random.uniform_double());
        DiscShot shot = aimed(disc, 1.5 * random.uniform_double(), sine, std::exp2(random.uniform(0, 10)), random);
        shot.ray.direction *= std::pow(10.0F, random.uniform(-6, 6));
        const std::optional<float> got = reference(shot.ray, disc);
        const std::optional<float> exact = oracle(shot.ray, disc);
        if (got.has_value() != exact.has_value()) {
            const double from_centre = length(glm::dvec3(shot.ray.origin) - glm::dvec3(disc.centre));
            const double margin = std::abs(depth_inside_rim(shot)) * double{disc.radius} / ulp_of(from_centre);
            ASSERT_LT(margin * sine, 1e-6) << "seed " << seed << ", ray " << i;
            continue;
        }
        if (got) {
            ASSERT_LE(tests::ulps_between(*got, *exact), 1) << "seed " << seed << ", ray " << i;
        }
    }
}

// The hard cases must tell the forms apart: float fails most of them.
TEST(DiscAccuracy, float_fails_where_rays_graze)
{
    const auto in_float = tests::solution<Intersect>(IN_FLOAT_MODULE);
    const auto oracle = tests::solution<Intersect>(ORACLE_MODULE);
    Random random(51004);
    int right = 0;
    for (const auto& [ray, disc] : grazing_pairs(random, 1000)) {
        const std::optional<float> got = in_float(ray, disc);
        const std::optional<float> exact = oracle(ray, disc);
        right += got && exact && tests::ulps_between(*got, *exact) <= 1 ? 1 : 0;
    }
    EXPECT_LT(right, 50) << "of 1000 hits";
}
