#include <gtest/gtest.h>

#include <bench/accuracy/ray_sphere.hpp>
#include <bench/accuracy/textbook.hpp>
#include <cmath>

namespace umbral::bench {
namespace {

const raytracing::Sphere unit{{0, 0, 0}, 1};

TEST(Textbook, knows_what_a_hand_can_work_out)
{
    for (Intersect* const variant : {intersect_school, intersect_double}) {
        EXPECT_EQ(variant(Ray{{0, 0, 5}, {0, 0, -1}}, unit), 4.0F);
        EXPECT_EQ(variant(Ray{{0, 0, 5}, {0, 0, -4}}, unit), 1.0F);
        EXPECT_EQ(variant(Ray{{0, 0, 0}, {0, 0, -1}}, unit), 1.0F);
        EXPECT_EQ(variant(Ray{{1, 0, 5}, {0, 0, -1}}, unit), 5.0F);
        EXPECT_EQ(variant(Ray{{0, 0, 5}, {0, 0, 1}}, unit), std::nullopt);
        EXPECT_EQ(variant(Ray{{2, 0, 5}, {0, 0, -1}}, unit), std::nullopt);
        EXPECT_EQ(variant(Ray{{0, 0, 5}, {0, 0, -1}, 4.5F}, unit), 6.0F);
        EXPECT_EQ(variant(Ray{{0, 0, 5}, {0, 0, 0}}, unit), std::nullopt);
        EXPECT_EQ(variant(Ray{{0, 0, NAN}, {0, 0, -1}}, unit), std::nullopt);
    }
}

TEST(Textbook, counts_errors_in_ulps_of_the_truth)
{
    EXPECT_EQ(error_in_ulp(4.0F, 4), 0);
    EXPECT_EQ(error_in_ulp(std::nextafter(4.0F, 9.0F), 4), 1);
    EXPECT_EQ(error_in_ulp(std::nextafter(4.0F, 0.0F), 4), 0.5);  // below a power of two floats lie twice as close
    EXPECT_EQ(error_in_ulp(4.0F, Wide(4) + Wide(std::ldexp(1.0, -22))), 0.5);
}

TEST(RaySphere, the_oracle_is_the_truth_rounded_once)
{
    Intersect* const oracle = sphere_solution(UMBRAL_UNITS, "oracle");
    Random random(3);
    for (const double distance : {10.0, 1e4, 1e6}) {
        const ShotErrors errors = errors_of(oracle, shots_from(distance, 4000, random));
        EXPECT_LE(errors.worst, 0.5) << distance;
        EXPECT_GT(errors.p95, 0.4) << distance;
        EXPECT_EQ(errors.wrong_hits, 0) << distance;
    }
}

TEST(RaySphere, the_school_formula_is_worse_than_the_reference_from_afar)
{
    Random random(4);
    const std::vector<Shot> shots = shots_from(1e4, 4000, random);
    const ShotErrors school = errors_of(intersect_school, shots);
    const ShotErrors reference = errors_of(sphere_solution(UMBRAL_UNITS, "reference"), shots);
    EXPECT_GT(school.p95, 100 * reference.p95);
    EXPECT_GT(school.worst, 100 * reference.worst);
    EXPECT_GT(school.wrong_hits, 20);
    EXPECT_LT(reference.wrong_hits, 0.2);
    const ShotErrors wide = errors_of(intersect_double, shots);
    EXPECT_LT(wide.p95, reference.p95);
}

TEST(RaySphere, aims_so_that_the_share_of_hits_is_known)
{
    // Uniform over a disc of 1.3 radii: 1 / 1.69 of all rays hit.
    Random random(5);
    for (const double distance : {10.0, 1e6}) {
        int hits = 0;
        const std::vector<Shot> shots = shots_from(distance, 20'000, random);
        for (const auto& [ray, sphere] : shots) hits += intersect_exactly(ray, sphere) ? 1 : 0;
        EXPECT_NEAR(hits / 20'000.0, 1 / 1.69, 0.015) << distance;  // four standard deviations
    }
}

TEST(RaySphere, a_missing_library_is_named)
{
    try {
        (void)sphere_solution("/nowhere", "oracle");
        FAIL() << "a library that is not there was opened";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what())
                      .find("expected the oracle of raytracing/sphere at /nowhere/raytracing/sphere/oracle.so"),
                  std::string::npos)
            << error.what();
    }
}

}
}
