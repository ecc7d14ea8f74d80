#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <umbral/core/random.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "curved_functions.hpp"

using namespace umbral;
using namespace umbral::projections;

namespace {

constexpr double pi = std::numbers::pi;
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

/// Every test here holds for the reference and for the oracle.
class CurvedSolution : public testing::TestWithParam<const char*> {
protected:
    const CurvedFunctions& solution() const { return *tests::solution_table<CurvedFunctions>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Solutions, CurvedSolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

double area(std::span<const glm::vec3> corners)
{
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const glm::dvec3 a(corners[i]);
        sum += 0.5 * length(cross(glm::dvec3(corners[i + 1]) - a, glm::dvec3(corners[i + 2]) - a));
    }
    return sum;
}

std::vector<glm::vec3> random_triangles(std::size_t count, Random& random)
{
    std::vector<glm::vec3> corners(3 * count);
    for (glm::vec3& corner : corners)
        for (int axis = 0; axis < 3; ++axis) corner[axis] = static_cast<float>(random.below(65)) / 4 - 8;
    return corners;
}

}

TEST_P(CurvedSolution, known_answers)
{
    const CurvedPoint sphere = solution().sphere({3, 4, -12}).value();
    EXPECT_EQ(sphere.place, glm::vec2(3 / 13.0F, 4 / 13.0F));
    EXPECT_EQ(sphere.distance, 13);
    const CurvedPoint cylinder = solution().cylinder({4, 2, 4}).value();
    EXPECT_NEAR(cylinder.place.x, 0.75 * pi, 3e-7);
    EXPECT_NEAR(cylinder.place.y, 2 / std::sqrt(32.0), 3e-8);
    EXPECT_EQ(cylinder.distance, 6);
    EXPECT_FALSE(solution().sphere({1, 1, 0.001F}));
    EXPECT_FALSE(solution().sphere({0, 0, 0}));
    EXPECT_EQ(solution().sphere({0, 0.5F, 0}).value().place, glm::vec2(0, 1));
    EXPECT_FALSE(solution().cylinder({0, 5, 0}));
    for (const float zero : {0.0F, -0.0F})
        EXPECT_EQ(solution().cylinder({zero, 1, 2}).value().place.x, static_cast<float>(pi)) << "straight behind";
    EXPECT_EQ(solution().angle({0, 0, 0}, {1, 2, 3}), 0);
    EXPECT_EQ(solution().angle({1, 0, 0}, {-2, 0, 0}), static_cast<float>(pi));
}

// The ray of a place, as long as the distance, leads back to the point.
TEST_P(CurvedSolution, place_and_distance_lead_back_to_the_point)
{
    constexpr std::uint64_t seed = 31001;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const float size = std::pow(10.0F, random.uniform(-30, 30));
        const glm::vec3 point = size * random.unit_vector();
        const double tolerance = 1e-6 * size;
        const CurvedPoint rolled = solution().cylinder(point).value();
        const double x = rolled.place.x;
        const glm::dvec3 ray = normalize(glm::dvec3(std::sin(x), rolled.place.y, -std::cos(x)));
        EXPECT_LT(distance(double{rolled.distance} * ray, glm::dvec3(point)), tolerance);
        if (point.z > 0) continue;
        const CurvedPoint seen = solution().sphere(point).value();
        const glm::dvec2 place(seen.place);
        EXPECT_LT(distance(double{seen.distance} * place, glm::dvec2(point)), tolerance);
        ASSERT_FALSE(HasFailure()) << "seed " << seed << ", point " << i;
    }
}

// A turn by a known angle about a known axis: half angles are not computed by any cosine of the angle.
TEST_P(CurvedSolution, angles_of_turned_vectors)
{
    constexpr std::uint64_t seed = 31002;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const double exact = pi * random.uniform();
        const glm::vec3 a(0, std::cos(exact), std::sin(exact));
        const float size = std::pow(10.0F, random.uniform(-20, 20));
        EXPECT_NEAR(solution().angle({0, size, 0}, a), exact, 2e-7) << "seed " << seed << ", angle " << i;
    }
    EXPECT_NEAR(solution().angle({1, 0, 0}, {1, 1e-7F, 0}), 1e-7, 1e-14);
}

TEST_P(CurvedSolution, tessellation_keeps_area_and_sense_and_ends_below_the_angle)
{
    constexpr std::uint64_t seed = 31003;
    Random random(seed);
    for (int i = 0; i < 25; ++i) {
        const std::vector<glm::vec3> corners = random_triangles(1 + random.below(3), random);
        const float largest = random.uniform(0.4F, 2);
        const std::vector<glm::vec3> cut = solution().tessellated(corners, largest);
        EXPECT_NEAR(area(cut), area(corners), 1e-9 * (1 + area(corners)));
        double times = std::log2(static_cast<double>(cut.size()) / static_cast<double>(corners.size())) / 2;
        EXPECT_EQ(times, std::round(times)) << "all of them equally often";
        const std::size_t parts = cut.size() / corners.size();
        EXPECT_EQ(cut.size(), parts * corners.size());
        double widest = 0;
        for (std::size_t k = 0; k < cut.size(); ++k)
            widest = std::max(widest, double{solution().angle(cut[k], cut[k % 3 == 2 ? k - 2 : k + 1])});
        EXPECT_TRUE(widest <= largest || times == 6);
        ASSERT_FALSE(HasFailure()) << "seed " << seed << ", list " << i;
    }
    const std::vector<glm::vec3> wall = {{-1, 0, -2}, {1, 0, -2}, {0, 2, -2}};
    EXPECT_EQ(solution().tessellated(wall, 1), wall);
    const std::vector<glm::vec3> finer = solution().tessellated(wall, 0.3F);
    EXPECT_EQ(finer.size(), 16 * 3u);
    for (std::size_t k = 0; k < finer.size(); k += 3)
        EXPECT_GT(cross(finer[k + 1] - finer[k], finer[k + 2] - finer[k]).z, 0) << "the sense of the whole";
    EXPECT_EQ(solution().tessellated(std::vector<glm::vec3>{}, 1).size(), 0u);
}

TEST_P(CurvedSolution, what_is_no_list_of_triangles_is_refused)
{
    const std::vector<glm::vec3> four(4, glm::vec3(1, 2, -3));
    EXPECT_THROW((void)solution().tessellated(four, 1), std::invalid_argument);
    for (const float wrong : {0.0F, -1.0F, no_number})
        EXPECT_THROW((void)solution().tessellated(std::span(four).first(3), wrong), std::invalid_argument);
}

// The same directions, none of them farther than half a turn from the first.
TEST_P(CurvedSolution, seam_is_crossed_by_whole_turns)
{
    constexpr std::uint64_t seed = 31004;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        std::array<float, 3> angles{};
        for (float& angle : angles) angle = static_cast<float>(pi) * random.uniform(-1, 1);
        const std::array<float, 3> moved = solution().without_seam(angles);
        EXPECT_EQ(moved[0], angles[0]);
        for (std::size_t k = 1; k < 3; ++k) {
            EXPECT_LE(std::abs(moved[k] - moved[0]), pi + 1e-6);
            EXPECT_NEAR(std::cos(double{moved[k]}), std::cos(double{angles[k]}), 5e-7);
            EXPECT_NEAR(std::sin(double{moved[k]}), std::sin(double{angles[k]}), 5e-7);
        }
        ASSERT_FALSE(HasFailure()) << "seed " << seed << ", triple " << i;
    }
}

// The header's guarantee: one rounding to float.
TEST(CurvedAccuracy, reference_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 31005;
    const CurvedFunctions& reference = *tests::solution_table<CurvedFunctions>(REFERENCE_MODULE);
    const CurvedFunctions& oracle = *tests::solution_table<CurvedFunctions>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const float size = std::pow(10.0F, random.uniform(-34, 36));
        const glm::vec3 point = size * random.unit_vector();
        const CurvedPoint got = reference.cylinder(point).value();
        const CurvedPoint exact = oracle.cylinder(point).value();
        for (int axis = 0; axis < 2; ++axis)
            ASSERT_LE(tests::ulps_between(got.place[axis], exact.place[axis]), 1) << "seed " << seed << ", " << i;
        ASSERT_LE(tests::ulps_between(got.distance, exact.distance), 1) << "seed " << seed << ", " << i;
        const glm::vec3 other = point + size * std::pow(10.0F, random.uniform(-6, 0)) * random.unit_vector();
        ASSERT_LE(tests::ulps_between(reference.angle(point, other), oracle.angle(point, other)), 1)
            << "seed " << seed << ", " << i;
    }
}
