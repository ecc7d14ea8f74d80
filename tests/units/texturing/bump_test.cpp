#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <texturing/support.hpp>
#include <umbral/texturing/bump.hpp>

// Linked with the reference. What is expected was worked out by hand, or comes from surfaces that really are raised,
// differentiated in double.

using namespace umbral;
using namespace umbral::texturing;

namespace {

void expect_near(const glm::vec3& actual, const glm::dvec3& expected, double tolerance, const std::string& about)
{
    for (int i = 0; i < 3; ++i) ASSERT_NEAR(actual[i], expected[i], tolerance) << about;
}

}

TEST(Bump, known_answers)
{
    Grid<glm::vec4> row(4, 1);
    row.cells = {glm::vec4(0), glm::vec4(1), glm::vec4(3), glm::vec4(0)};
    EXPECT_EQ(slopes(row, {0.375F, 0.5F}, 1), glm::vec2(6, 0));
    EXPECT_EQ(slopes(row, {0.125F, 0.5F}, -2), glm::vec2(-4, 0)) << "the neighbour of the first texel is the last";

    const Tangents mirrored = triangle_tangents({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{1, 0}, {0, 0}, {1, 1}}});
    EXPECT_EQ(mirrored.u, glm::vec3(-1, 0, 0));
    EXPECT_EQ(mirrored.v, glm::vec3(0, 1, 0));

    const glm::vec3 n = bumped_normal({0, 0, 1}, {{2, 0, 0}, {1, 1, 0}}, {1, 0});
    expect_near(n, glm::dvec3(-1, 1, 2) / std::sqrt(6.0), 1e-7, "the statement's number");
    expect_near(bumped_normal({0, 0, 1}, {{1, 0, 0}, {0, 1, 0}}, {0.5F, -0.25F}),
                glm::normalize(glm::dvec3(-0.5, 0.25, 1)), 1e-7, "a normal map's texel");
}

// Heights whose slopes are known: a plane sampled in the middle of its texture, away from where it begins again.
TEST(Bump, slopes_of_a_plane_are_its_own)
{
    constexpr std::uint64_t seed = 20331;
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        const float by_u = random.uniform(-1, 1);
        const float by_v = random.uniform(-1, 1);
        Grid<glm::vec4> plane(16, 8);
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 16; ++x)
                plane.at(x, y).r =
                    by_u * (static_cast<float>(x) + 0.5F) / 16 - by_v * (static_cast<float>(y) + 0.5F) / 8;
        const glm::vec2 uv(random.uniform(0.25F, 0.75F), random.uniform(0.3F, 0.7F));
        const glm::vec2 actual = slopes(plane, uv, 3);
        ASSERT_NEAR(actual.x, 3 * by_u, 2e-5F) << "seed " << seed;
        ASSERT_NEAR(actual.y, 3 * by_v, 2e-5F) << "seed " << seed;
    }
}

// A triangle cut from a known map from the texture to space: p = p0 + u a + v b.
TEST(Bump, tangents_are_those_of_the_map_that_made_the_triangle)
{
    constexpr std::uint64_t seed = 20332;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const glm::dvec3 a = random.in_cube();
        const glm::dvec3 b = random.in_cube();
        const glm::dvec3 origin = random.in_cube();
        std::array<glm::vec2, 3> coordinates{};
        for (glm::vec2& at : coordinates) {
            const float u = random.uniform(-1, 1);
            at = {u, random.uniform(-1, 1)};
        }
        const glm::vec2 c1 = coordinates[1] - coordinates[0];
        const glm::vec2 c2 = coordinates[2] - coordinates[0];
        if (std::abs(c1.x * c2.y - c2.x * c1.y) < 0.1F) continue;
        std::array<glm::vec3, 3> positions{};
        for (std::size_t k = 0; k < 3; ++k)
            positions[k] = origin + double{coordinates[k].x} * a + double{coordinates[k].y} * b;
        const Tangents tangents = triangle_tangents(positions, coordinates);
        expect_near(tangents.u, a, 1e-5, "seed " + std::to_string(seed));
        expect_near(tangents.v, b, 1e-5, "seed " + std::to_string(seed));
    }
}

TEST(Bump, a_line_in_the_texture_has_no_tangents)
{
    const Tangents none = triangle_tangents({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{0, 0}, {1, 1}, {2, 2}}});
    EXPECT_EQ(none.u, glm::vec3(0));
    EXPECT_EQ(none.v, glm::vec3(0));
    EXPECT_EQ(bumped_normal({0, 1, 0}, none, {3, 4}), glm::vec3(0, 1, 0));
}

// Ellipsoids that are really raised along their normals, and stretched differently along each axis: the normal is that
// of the raised surface, from its derivatives by differences in double. Half of them have mirrored coordinates.
TEST(Bump, the_normal_is_that_of_the_raised_surface)
{
    constexpr std::uint64_t seed = 20333;
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 radii(random.uniform(0.5F, 3), random.uniform(0.5F, 3), random.uniform(0.5F, 3));
        const double direction = i % 2 == 0 ? 1 : -1;
        const double u0 = random.uniform(0, 6);
        const double v0 = random.uniform(-1, 1);
        // Only slopes of the height count, so it may be 0 at the point itself.
        const glm::dvec2 slope(random.uniform(-1, 1), random.uniform(-1, 1));
        const auto flat = [&](double u, double v) {
            return radii * glm::dvec3(std::cos(direction * u) * std::cos(v), std::sin(direction * u) * std::cos(v),
                                      std::sin(v));
        };
        const auto normal_at = [&](double u, double v) { return normalize(flat(u, v) / (radii * radii)); };
        const auto raised = [&](double u, double v) {
            return flat(u, v) + (slope.x * (u - u0) + slope.y * (v - v0)) * normal_at(u, v);
        };
        constexpr double h = 1e-5;
        const auto by_u = [&](const auto& f) { return (f(u0 + h, v0) - f(u0 - h, v0)) / (2 * h); };
        const auto by_v = [&](const auto& f) { return (f(u0, v0 + h) - f(u0, v0 - h)) / (2 * h); };
        const glm::dvec3 n = normal_at(u0, v0);
        glm::dvec3 expected = normalize(cross(by_u(raised), by_v(raised)));
        if (dot(expected, n) < 0) expected = -expected;
        const Tangents tangents{by_u(flat), by_v(flat)};
        expect_near(bumped_normal(n, tangents, slope), expected, 2e-6, "seed " + std::to_string(seed));
    }
}

// A model that is scaled differently along each axis: tangents by the matrix, the normal by the inverse transpose, and
// the heights in the world. Then it is the same as a triangle that was scaled before.
TEST(Bump, scaled_models_need_scaled_tangents)
{
    constexpr std::uint64_t seed = 20334;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        const glm::mat3 model(glm::vec3(random.uniform(0.5F, 3), 0, 0),
                              glm::vec3(random.uniform(-1, 1), random.uniform(0.5F, 3), 0),
                              glm::vec3(0, random.uniform(-1, 1), random.uniform(0.5F, 3)));
        const std::array<glm::vec3, 3> positions = {random.in_cube(), random.in_cube() + glm::vec3(3, 0, 0),
                                                    random.in_cube() + glm::vec3(0, 3, 0)};
        const std::array<glm::vec2, 3> coordinates = {{{0, 0}, {1, 0.2F}, {0.1F, 1}}};
        const std::array<glm::vec3, 3> scaled = {model * positions[0], model * positions[1], model * positions[2]};
        const Tangents tangents = triangle_tangents(positions, coordinates);
        const glm::vec3 n = normalize(cross(positions[1] - positions[0], positions[2] - positions[0]));
        const glm::vec3 world_n = normalize(glm::inverseTranspose(model) * n);
        const glm::vec3 expected = bumped_normal(normalize(cross(scaled[1] - scaled[0], scaled[2] - scaled[0])),
                                                 triangle_tangents(scaled, coordinates), {0.7F, -0.4F});
        expect_near(bumped_normal(world_n, {model * tangents.u, model * tangents.v}, {0.7F, -0.4F}), expected, 4e-6,
                    "seed " + std::to_string(seed));
    }
}
