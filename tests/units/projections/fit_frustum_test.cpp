#include "fit_frustum_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"

using namespace umbral;
using namespace umbral::projections;

namespace {

constexpr PictureSize square{512, 512};

/// Every test here holds for the reference and for the oracle.
class FitSolution : public testing::TestWithParam<const char*> {
protected:
    const Fit& solution() const { return *tests::solution_table<Fit>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Solutions, FitSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

void expect_volume(const ViewVolume& got, double right, double top, double near_plane, double far_plane)
{
    EXPECT_NEAR(got.right, right, 1e-7 * right);
    EXPECT_NEAR(got.top, top, 1e-7 * top);
    EXPECT_EQ(got.left, -got.right);
    EXPECT_EQ(got.bottom, -got.top);
    EXPECT_NEAR(got.near_plane, near_plane, 1e-7 * near_plane);
    EXPECT_NEAR(got.far_plane, far_plane, 1e-7 * far_plane);
}

/// The extremes that a projection reaches: every number should be 1, and for the longer side of a picture less.
struct Reach {
    glm::dvec2 sides{0};
    double nearest = 1;
    double farthest = -1;

    void see(const ViewVolume& v, const glm::dvec3& place)
    {
        const glm::dmat4 projection = glm::frustum<double>(v.left, v.right, v.bottom, v.top, v.near_plane, v.far_plane);
        const glm::dvec4 clip = projection * glm::dvec4(place, 1);
        const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
        sides = glm::max(sides, glm::abs(glm::dvec2(ndc)));
        nearest = std::min(nearest, ndc.z);
        farthest = std::max(farthest, ndc.z);
    }

    void expect_tight(const PictureSize& picture, double tolerance) const
    {
        const double aspect = double(picture.width) / picture.height;
        EXPECT_NEAR(sides.x, aspect > 1 ? 1 / aspect : 1, tolerance);
        EXPECT_NEAR(sides.y, aspect < 1 ? aspect : 1, tolerance);
        EXPECT_NEAR(nearest, -1, tolerance);
        EXPECT_NEAR(farthest, 1, tolerance);
    }
};

Reach cube_seen(const ViewVolume& volume, double side, double distance)
{
    Reach reach;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto place = [&](unsigned bit) { return (corner & bit) != 0 ? side / 2 : -side / 2; };
        reach.see(volume, {place(1), place(2), place(4) - distance});
    }
    return reach;
}

}

// The course's answers.
TEST_P(FitSolution, problems_3_5_to_3_8)
{
    for (const float s : {0.5F, 1.0F, 2.0F, 8.0F})
        expect_volume(solution().cube(s, s + 2, square), 0.5 * s, 0.5 * s, 0.5 * s + 2, 1.5 * s + 2);
    for (const float r : {0.5F, 1.0F, 3.0F, 8.0F}) {
        expect_volume(solution().sphere(r, r + 2, square), r / std::sqrt(r + 1.0), r / std::sqrt(r + 1.0), 2,
                      2 * r + 2);
        const double t = r * std::sqrt((r + 2.0) / (3.0 * r + 2));
        expect_volume(solution().sphere(r, 2 * r + 2, square), t, t, r + 2, 3 * r + 2);
    }
    expect_volume(solution().cube(2, 4, {1280, 720}), 16.0 / 9, 1, 3, 5);
    expect_volume(solution().cube(2, 4, {720, 1280}), 1, 16.0 / 9, 3, 5);
    for (const float fovy : {10.0F, 40.0F, 60.0F, 90.0F, 120.0F}) {
        const PlacedVolume placed = solution().cube_to_fovy({1, 2, 3}, 2, fovy, square);
        const double n = 1 / std::tan(glm::radians(double{fovy}) / 2);
        expect_volume(placed.volume, 1, 1, n, n + 2);
        EXPECT_NEAR(placed.eye.z, 4 + n, 1e-6);
        EXPECT_EQ(glm::vec2(placed.eye), glm::vec2(1, 2));
    }
}

TEST_P(FitSolution, nothing_is_clipped_and_nothing_is_wasted)
{
    constexpr std::uint64_t seed = 30601;
    Random random(seed);
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", body " + std::to_string(i));
        const int width = 1 + static_cast<int>(random.below(1000));
        const PictureSize picture{width, 1 + static_cast<int>(random.below(1000))};
        const float size = random.uniform(0.1F, 5);
        const float distance = size * random.uniform(1.2F, 5);
        cube_seen(solution().cube(size, distance, picture), size, distance).expect_tight(picture, 1e-5);

        const float fovy = random.uniform(5, 150);
        const PlacedVolume placed = solution().cube_to_fovy({0, 0, 0}, size, fovy, picture);
        cube_seen(placed.volume, size, placed.eye.z).expect_tight(picture, 1e-4);
        EXPECT_NEAR(2 * std::atan(double{placed.volume.top} / placed.volume.near_plane), glm::radians(double{fovy}),
                    1e-6);

        // The widest circles of latitude that are seen, and the two poles.
        Reach sphere;
        const ViewVolume volume = solution().sphere(size, distance, picture);
        for (int step = 0; step <= 20'000; ++step) {
            const double angle = step * 3.14159265358979 / 20'000;
            const double aside = size * std::sin(angle);
            const double z = size * std::cos(angle) - distance;
            sphere.see(volume, {aside, 0, z});
            sphere.see(volume, {0, aside, z});
        }
        sphere.expect_tight(picture, 1e-5);
        if (HasFailure()) return;
    }
}

TEST_P(FitSolution, what_cannot_be_fitted_is_refused)
{
    EXPECT_THROW((void)solution().cube(2, 1, square), std::invalid_argument);
    EXPECT_THROW((void)solution().cube(0, 1, square), std::invalid_argument);
    EXPECT_THROW((void)solution().cube(2, 4, {0, 5}), std::invalid_argument);
    EXPECT_THROW((void)solution().sphere(1, 1, square), std::invalid_argument);
    EXPECT_THROW((void)solution().sphere(-1, 1, square), std::invalid_argument);
    EXPECT_THROW((void)solution().sphere(1, 2, {5, -1}), std::invalid_argument);
    EXPECT_THROW((void)solution().cube_to_fovy({}, 2, 180, square), std::invalid_argument);
    EXPECT_THROW((void)solution().cube_to_fovy({}, 2, 0, square), std::invalid_argument);
    EXPECT_THROW((void)solution().cube_to_fovy({}, -2, 60, square), std::invalid_argument);
}

// The header's guarantee.
TEST(FitAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 30602;
    const Fit& reference = *tests::solution_table<Fit>(REFERENCE_MODULE);
    const Fit& oracle = *tests::solution_table<Fit>(ORACLE_MODULE);
    const auto expect_near = [](const ViewVolume& got, const ViewVolume& exact) {
        EXPECT_LE(tests::ulps_between(got.right, exact.right), 1);
        EXPECT_LE(tests::ulps_between(got.top, exact.top), 1);
        EXPECT_LE(tests::ulps_between(got.near_plane, exact.near_plane), 1);
        EXPECT_LE(tests::ulps_between(got.far_plane, exact.far_plane), 1);
    };
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", body " + std::to_string(i));
        const PictureSize picture{1 + static_cast<int>(random.below(4000)), 1080};
        const float radius = std::pow(10.0F, random.uniform(-25, 25));
        const float distance = radius * (1 + std::pow(10.0F, random.uniform(-6, 6)));
        expect_near(reference.sphere(radius, distance, picture), oracle.sphere(radius, distance, picture));
        expect_near(reference.cube(radius, distance, picture), oracle.cube(radius, distance, picture));
        const float rest = std::pow(10.0F, random.uniform(-4, 2));
        const float fovy = i % 2 == 0 ? rest : 180 - rest;
        expect_near(reference.cube_to_fovy({}, 2, fovy, picture).volume,
                    oracle.cube_to_fovy({}, 2, fovy, picture).volume);
        if (HasFailure()) return;
    }
}
