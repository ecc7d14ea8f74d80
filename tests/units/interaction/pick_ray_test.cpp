#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <interaction/pick-ray/clicks.hpp>

#include "../solution.hpp"
#include "../ulps.hpp"
#include "pick_ray_functions.hpp"

using namespace umbral;
using namespace umbral::interaction;

namespace {

/// Every test here holds for the reference and for the oracle.
class PickRaySolution : public testing::TestWithParam<const char*> {
protected:
    const PickRayFunctions& solution() const { return *tests::solution_table<PickRayFunctions>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Solutions, PickRaySolution, testing::Values(REFERENCE_MODULE, ORACLE_MODULE),
                         [](const auto& solution) { return solution.index == 0 ? "reference" : "oracle"; });

constexpr projections::ViewFrame world{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};

glm::dmat4 view_matrix_of(const projections::ViewFrame& frame)
{
    const glm::dmat3 axes(frame.x, frame.y, frame.z);
    const glm::dmat3 turned = transpose(axes);
    glm::dmat4 matrix(turned);
    matrix[3] = glm::dvec4(-(turned * glm::dvec3(frame.origin)), 1);
    return matrix;
}

glm::dmat4 projection_of(const projections::ViewVolume& v)
{
    return glm::frustum<double>(v.left, v.right, v.bottom, v.top, v.near_plane, v.far_plane);
}

void expect_near(const glm::dvec3& got, const glm::dvec3& expected, double tolerance)
{
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(got[axis], expected[axis], tolerance);
}

}

// The course's numbers, and some worked by hand.
TEST_P(PickRaySolution, known_answers)
{
    const PickView course{world, {-4.0F / 3, 4.0F / 3, -1, 1, 1, 100}, {640, 480}};
    expect_near(solution().ray(course, {0, 0}).direction, {-0.6858047233, 0.5140852308, -0.5151584776}, 5e-8);
    expect_near(solution().ray(course, {320, 240}).direction, {0.0020833243, -0.0020833243, -0.9999956598}, 5e-8);
    const PickView one{{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {5, 2, -1}}, {-1, 1, -1, 1, 0.5F, 8}, {1, 1}};
    const Ray ray = solution().ray(one, {0, 0});
    EXPECT_EQ(ray.origin, glm::vec3(5, 2, -1));
    EXPECT_EQ(ray.direction, glm::vec3(-1, 0, 0));
    EXPECT_EQ(ray.t_min, 0.5F);
    EXPECT_EQ(ray.t_max, 8);
    PickView endless = one;
    endless.frustum.far_plane = std::numeric_limits<float>::infinity();
    EXPECT_EQ(solution().ray(endless, {0, 0}).t_max, endless.frustum.far_plane);
}

TEST_P(PickRaySolution, known_pixels)
{
    EXPECT_EQ(solution().pixel({10.5, 3.25}, {40, 20}, {80, 40}), glm::ivec2(21, 6));
    EXPECT_EQ(solution().pixel({0, 0}, {40, 20}, {40, 20}), glm::ivec2(0, 0));
    EXPECT_EQ(solution().pixel({39.99, 19.99}, {40, 20}, {60, 30}), glm::ivec2(59, 29));
    EXPECT_EQ(solution().pixel({10, 5}, {30, 15}, {10, 5}), glm::ivec2(3, 1)) << "a third of a pixel a coordinate";
    EXPECT_FALSE(solution().pixel({40, 3}, {40, 20}, {80, 40}));
    EXPECT_FALSE(solution().pixel({3, 20}, {40, 20}, {80, 40}));
    EXPECT_FALSE(solution().pixel({-0.25, 3}, {40, 20}, {80, 40}));
    EXPECT_FALSE(solution().pixel({0, 0}, {0, 0}, {0, 0}));
}

TEST_P(PickRaySolution, the_twin_of_a_click_in_the_window_has_no_pixel)
{
    constexpr std::uint64_t seed = 43001;
    Random random(seed);
    std::vector<Click> clicks = random_clicks(random, 2000);
    for (auto make : {clicks_at_borders, clicks_without_a_window}) {
        const std::vector<Click> more = make(random, 240);
        clicks.insert(clicks.end(), more.begin(), more.end());
    }
    for (std::size_t i = 0; i < clicks.size(); i += 2) {
        const auto found = [&](const Click& c) { return solution().pixel(c.cursor, c.window, c.framebuffer); };
        const std::optional<glm::ivec2> one = found(clicks[i]);
        const std::optional<glm::ivec2> other = found(clicks[i + 1]);
        ASSERT_NE(one.has_value(), other.has_value()) << "seed " << seed << ", pair " << i / 2;
        const Click& click = one ? clicks[i] : clicks[i + 1];
        const glm::dvec2 pixel(one ? *one : *other);
        // The pixel's borders in screen coordinates lie on both sides of the cursor.
        const glm::dvec2 size = glm::dvec2(click.window) / glm::dvec2(click.framebuffer);
        for (int axis = 0; axis < 2; ++axis) {
            ASSERT_LE(pixel[axis] * size[axis], click.cursor[axis] + 1e-9) << "seed " << seed << ", pair " << i / 2;
            ASSERT_GT((pixel[axis] + 1) * size[axis], click.cursor[axis] - 1e-9) << "seed " << seed;
        }
    }
}

// What the ray passes in the two planes is what glm::unProject finds there.
TEST_P(PickRaySolution, agrees_with_glm_unproject)
{
    constexpr std::uint64_t seed = 43002;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        PickView view = random_pick_view(random);
        if (!std::isfinite(view.frustum.far_plane)) view.frustum.far_plane = 500;
        const glm::ivec2 pixel = random_pixel(view.picture, random);
        const Ray ray = solution().ray(view, pixel);
        // Window coordinates have their origin at the lower left corner.
        const glm::dvec2 place(pixel.x + 0.5, view.picture.y - (pixel.y + 0.5));
        for (const double depth : {0.0, 1.0}) {
            const glm::dvec3 there = glm::unProject(glm::dvec3(place, depth), view_matrix_of(view.frame),
                                                    projection_of(view.frustum), glm::dvec4(0, 0, view.picture));
            const double t = depth == 0 ? ray.t_min : ray.t_max;
            const glm::dvec3 got = glm::dvec3(ray.origin) + t * glm::dvec3(ray.direction);
            ASSERT_LT(distance(got, there), 3e-7 * t + 1e-12) << "seed " << seed << ", view " << i;
        }
    }
}

TEST_P(PickRaySolution, points_of_the_ray_appear_at_the_centre_of_the_pixel)
{
    constexpr std::uint64_t seed = 43003;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const PickView view = random_pick_view(random);
        const glm::ivec2 pixel = random_pixel(view.picture, random);
        const Ray ray = solution().ray(view, pixel);
        ASSERT_NEAR(length(glm::dvec3(ray.direction)), 1, 1e-7) << "seed " << seed << ", view " << i;
        const glm::dvec3 far_away = glm::dvec3(ray.origin) + 7.0 * glm::dvec3(ray.direction);
        const glm::dvec3 in_camera(view_matrix_of(view.frame) * glm::dvec4(far_away, 1));
        const glm::dvec2 on_near = glm::dvec2(in_camera) * (-view.frustum.near_plane / in_camera.z);
        const auto& [left, right, bottom, top, near_plane, far_plane] = view.frustum;
        const glm::dvec2 share((on_near.x - left) / (double{right} - left), (top - on_near.y) / (double{top} - bottom));
        const glm::dvec2 centre = share * glm::dvec2(view.picture);
        ASSERT_LT(distance(centre, glm::dvec2(pixel) + 0.5), 2e-3) << "seed " << seed << ", view " << i;
    }
}

TEST(PickRayAccuracy, reference_agrees_with_the_oracle)
{
    constexpr std::uint64_t seed = 43004;
    const auto& reference = *tests::solution_table<PickRayFunctions>(REFERENCE_MODULE);
    const auto& oracle = *tests::solution_table<PickRayFunctions>(ORACLE_MODULE);
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        PickView view = random_pick_view(random);
        view.picture *= 1 << random.below(20);
        view.frame.origin *= std::exp2(random.uniform(0, 17));
        const glm::ivec2 pixel = random_pixel(view.picture, random);
        const Ray got = reference.ray(view, pixel);
        const Ray exact = oracle.ray(view, pixel);
        ASSERT_EQ(got.origin, exact.origin);
        for (int axis = 0; axis < 3; ++axis)
            ASSERT_NEAR(got.direction[axis], exact.direction[axis], 6e-8) << "seed " << seed << ", view " << i;
        ASSERT_LE(tests::ulps_between(got.t_min, exact.t_min), 1) << "seed " << seed << ", view " << i;
        ASSERT_EQ(std::isfinite(got.t_max), std::isfinite(exact.t_max)) << "seed " << seed << ", view " << i;
        if (!std::isfinite(exact.t_max)) continue;
        ASSERT_LE(tests::ulps_between(got.t_max, exact.t_max), 1) << "seed " << seed << ", view " << i;
    }
    for (const Click& c : random_clicks(random, 20'000))
        ASSERT_EQ(reference.pixel(c.cursor, c.window, c.framebuffer), oracle.pixel(c.cursor, c.window, c.framebuffer));
}
