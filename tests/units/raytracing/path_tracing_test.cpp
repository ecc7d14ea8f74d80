#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <raytracing/path-tracing/furnaces.hpp>
#include <raytracing/path-tracing/questions.hpp>
#include <raytracing/rays.hpp>

#include "lamp_means.hpp"
#include "support/all_tests.hpp"

using namespace umbral;
using namespace umbral::raytracing;
using namespace umbral::tests;

namespace {

/// The solid angle of a triangle seen from the origin. Based on: A. Van Oosterom, J. Strackee. The Solid Angle of a
/// Plane Triangle. IEEE Transactions on Biomedical Engineering 1983.
double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const double la = length(a);
    const double lb = length(b);
    const double lc = length(c);
    const double below = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la;
    return 2 * std::atan2(std::abs(dot(a, cross(b, c))), below);
}

void expect_light(const RoomView& view, std::uint64_t seed, int count, const glm::dvec3& expected)
{
    Random random(seed);
    const Mean found =
        mean_of(count, [&] { return path_light(view.room, view.ray, view.bounces, view.samples, random); });
    expect_mean(found, expected, view.name);
}

}

// Chi squared over 8 bands of equal chance times 12 sectors, round normals of all kinds.
TEST(PathTracing, directions_have_the_density_of_the_cosine)
{
    const std::uint64_t seed = 20261;
    SCOPED_TRACE(seed);
    Random random(seed);
    constexpr int cells = 96;
    const int count = samples_for_tests(500000);
    std::vector<glm::vec3> normals = normals_of_directions();
    normals.push_back(random.unit_vector());
    normals.push_back(glm::normalize(glm::vec3(1e-4F, -1e-4F, -1)));
    for (const glm::vec3& normal : normals) {
        const glm::vec3 x = glm::vec3(perpendicular_to(normal, random));
        const glm::vec3 y = cross(normal, x);
        std::vector<double> found(cells);
        for (int i = 0; i < count; ++i) {
            const glm::vec3 direction = cosine_direction(normal, random);
            ASSERT_NEAR(length(direction), 1, 1e-6);
            const double height = dot(direction, normal);
            ASSERT_GT(height, 0);
            // The squared cosine is uniform, and so is the angle round the normal.
            const int band = std::min(7, static_cast<int>(8 * height * height));
            const double turn = std::atan2(dot(direction, y), dot(direction, x)) / (2 * pi) + 0.5;
            found[static_cast<std::size_t>(12 * band + std::min(11, static_cast<int>(12 * turn)))] += 1;
        }
        double sum = 0;
        const double expected = count / double{cells};
        for (const double one : found) sum += (one - expected) * (one - expected) / expected;
        // 95 degrees of freedom: 166 is passed once in 100,000.
        EXPECT_LT(sum, 166) << normal.x << ' ' << normal.y << ' ' << normal.z;
    }
}

TEST(PathTracing, densities_integrate_to_one)
{
    Random random(20262);
    // Over uniform directions, whose density is 1 / (4 pi).
    const glm::vec3 normal = random.unit_vector();
    expect_mean(
        mean_of(200000, [&] { return glm::vec3(4 * float(pi) * cosine_density(normal, random.unit_vector()), 1, 1); }),
        glm::dvec3(1), "the density of the cosine");
    // The mean of 1 / density over the lamp is its solid angle, which has a formula of its own.
    for (const LampView& view : random_lamps(random, 5)) {
        const glm::dvec3 corner = glm::dvec3(view.lamp.corner) - glm::dvec3(view.point);
        const glm::dvec3 a(view.lamp.edge_a);
        const glm::dvec3 b(view.lamp.edge_b);
        const double angle =
            solid_angle(corner, corner + a, corner + b) + solid_angle(corner + a, corner + b, corner + a + b);
        const Mean found = mean_of(40000, [&] {
            const float u = random.uniform();
            const glm::vec3 place = view.lamp.corner + u * view.lamp.edge_a + random.uniform() * view.lamp.edge_b;
            return glm::vec3(1 / lamp_density(view.point, view.lamp, place));
        });
        expect_mean(found, glm::dvec3(angle), "the solid angle of a lamp");
    }
}

TEST(PathTracing, known_answers)
{
    const AreaLamp lamp{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
    EXPECT_FLOAT_EQ(lamp_density({0.5F, 0.5F, 2}, lamp, {0.5F, 0.5F, 0}), 4);
    EXPECT_FLOAT_EQ(lamp_density({0.5F, 4.5F, 3}, lamp, {0.5F, 0.5F, 0}), 25 / 0.6F);
    EXPECT_FLOAT_EQ(cosine_density({0, 1, 0}, {0.6F, 0.8F, 0}), 0.8F / float(pi));
    EXPECT_EQ(cosine_density({0, 1, 0}, {0.6F, -0.8F, 0}), 0);
}

TEST(PathTracing, lamp_densities_keep_their_guarantee)
{
    Random random(20263);
    double worst = 0;
    const int count = samples_for_tests(500000);
    for (const LampView& view : random_lamps(random, count)) {
        const glm::dvec3 way = glm::dvec3(view.on_lamp) - glm::dvec3(view.point);
        const glm::dvec3 normal = cross(glm::dvec3(view.lamp.edge_a), glm::dvec3(view.lamp.edge_b));
        const double exact = std::pow(length(way), 3) / std::abs(dot(normal, way));
        worst = std::max(worst, std::abs(lamp_density(view.point, view.lamp, view.on_lamp) / exact - 1));
    }
    std::printf("worst relative error of %d lamp densities: %.2g\n", count, worst);
    EXPECT_LT(worst, 1e-5);
}

// E (1 + a + … + a^n): closed forms.
TEST(PathTracing, furnaces_have_their_closed_form)
{
    for (const RoomView& view : furnaces()) {
        if (view.room.lamps().size() == 1) continue;
        const DiffusePoint wall = *view.room.first_hit(view.ray);
        const glm::dvec3 a(wall.albedo);
        glm::dvec3 reflected = 1.0 / (1.0 - a);
        if (view.bounces != all_bounces) reflected *= 1.0 - pow(a, glm::dvec3(view.bounces + 1));
        expect_light(view, 20264, samples_for_tests(20000), glm::dvec3(wall.emitted) * reflected);
    }
}

TEST(PathTracing, a_floor_under_sky_and_lamps_has_its_closed_form)
{
    const std::vector<RoomView> views = one_bounce();
    const glm::dvec3 albedo(0.8F, 0.5F, 0.2F);
    // A sky that grows with the cosine: its mean weighted with the cosine is a third horizon and two thirds zenith.
    expect_light(views[0], 20265, samples_for_tests(20000),
                 albedo * (glm::dvec3(0.2, 0.4, 0.6) + 2.0 * glm::dvec3(1.5, 1, 0.5)) / 3.0);
    const glm::dvec3 point(views[1].room.first_hit(views[1].ray)->position);
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
        glm::dvec3 light(0);
        for (const AreaLamp& lamp : views[i].room.lamps())
            light += glm::dvec3(lamp.radiance) * form_factor(point, {0, 1, 0}, lamp);
        expect_light(views[i], 20266, samples_for_tests(20000), albedo * light);
    }
}

// Samples are worth the same, however many are asked for, and calls leave nothing behind.
TEST(PathTracing, the_number_of_samples_changes_no_mean)
{
    RoomView view = furnaces().back();
    view.samples = 64;
    Random random(20267);
    const Mean many = mean_of(samples_for_tests(3000),
                              [&] { return path_light(view.room, view.ray, view.bounces, view.samples, random); });
    view.samples = 1;
    expect_light(view, 20268, samples_for_tests(60000), many.mean);
    Random first(1);
    Random again(1);
    EXPECT_EQ(path_light(view.room, view.ray, 3, 8, first), path_light(view.room, view.ray, 3, 8, again));
}
