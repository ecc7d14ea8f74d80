#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <raytracing/distributed/pixels.hpp>
#include <raytracing/distributed/questions.hpp>

#include "lamp_means.hpp"
#include "support/all_tests.hpp"

using namespace umbral;
using namespace umbral::raytracing;
using namespace umbral::tests;

namespace {

/// The share of the unit disc in which x > `edge`.
double disc_beyond(double edge)
{
    const double x = std::clamp(edge, -1.0, 1.0);
    return (std::acos(x) - x * std::sqrt(1 - x * x)) / pi;
}

Mean pixel_mean(const PixelQuestion& question, std::uint64_t seed, int count)
{
    Random random(seed);
    return mean_of(
        count, [&] { return pixel_light(question.scene, question.camera, question.size, question.pixel, 8, random); });
}

}

// Chi squared over 10 rings of equal area times 12 sectors.
TEST(Distributed, points_of_the_disc_are_uniform)
{
    const std::uint64_t seed = 20271;
    SCOPED_TRACE(seed);
    Random random(seed);
    constexpr int cells = 120;
    const int count = samples_for_tests(1000000);
    std::array<double, cells> found{};
    for (int i = 0; i < count; ++i) {
        const glm::dvec2 point(disc_point(random));
        ASSERT_LE(dot(point, point), 1 + 1e-6);
        const int ring = std::min(9, static_cast<int>(10 * dot(point, point)));
        const double turn = std::atan2(point.y, point.x) / (2 * pi) + 0.5;
        found[static_cast<std::size_t>(12 * ring + std::min(11, static_cast<int>(12 * turn)))] += 1;
    }
    double sum = 0;
    const double expected = count / double{cells};
    for (const double one : found) sum += (one - expected) * (one - expected) / expected;
    // 119 degrees of freedom: 197 is passed once in 100,000.
    EXPECT_LT(sum, 197);
}

// The ray from the eye is the one that GLM's matrices unproject, and all others meet it at the depth of the focus.
TEST(Distributed, rays_of_a_place_meet_in_the_plane_of_focus)
{
    const std::uint64_t seed = 20272;
    SCOPED_TRACE(seed);
    Random random(seed);
    double worst_direction = 0;
    double worst_meeting = 0;
    for (const auto& [camera, size, place, lens] : random_lenses(random, samples_for_tests(100000))) {
        const glm::dvec3 eye(camera.eye);
        const double aspect = double(size.width) / size.height;
        const glm::dmat4 view = glm::lookAt(eye, eye - glm::dvec3(camera.back), glm::dvec3(camera.up));
        const glm::dmat4 projection = glm::perspective(2 * std::atan(double(camera.half_height)), aspect, 0.5, 2.0);
        const glm::dvec3 window(place.x, double(size.height) - double(place.y), 0.5);
        const glm::dvec3 through = glm::unProject(window, view, projection, glm::dvec4(0, 0, size.width, size.height));
        const glm::dvec3 direction = normalize(through - eye);
        const Ray ray = lens_ray(camera, size, place, {0, 0});
        EXPECT_EQ(ray.origin, camera.eye);
        worst_direction = std::max(worst_direction, length(glm::dvec3(ray.direction) - direction));

        const Ray aside = lens_ray(camera, size, place, lens);
        EXPECT_NEAR(length(aside.direction), 1, 2e-7);
        const glm::dvec3 back(camera.back);
        const auto at_the_focus = [&](const Ray& one) {
            const glm::dvec3 origin = glm::dvec3(one.origin) - eye;
            const glm::dvec3 along(one.direction);
            return origin + (camera.focus_depth + dot(origin, back)) / -dot(along, back) * along;
        };
        worst_meeting =
            std::max(worst_meeting, length(at_the_focus(ray) - at_the_focus(aside)) / double(camera.focus_depth));
    }
    std::printf("seed %llu: directions within %.2g of GLM's, rays of a place meet within %.2g of the depth\n",
                static_cast<unsigned long long>(seed), worst_direction, worst_meeting);
    EXPECT_LT(worst_direction, 2e-6);
    EXPECT_LT(worst_meeting, 1e-5);
}

TEST(Distributed, known_rays)
{
    const LensCamera camera{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.5F, 0.5F, 4, 0, 0};
    const Ray middle = lens_ray(camera, {100, 100}, {50, 50}, {0, 0});
    EXPECT_EQ(middle.direction, glm::vec3(0, 0, -1));
    const Ray edge = lens_ray(camera, {100, 100}, {100, 50}, {1, 0});
    EXPECT_EQ(edge.origin, glm::vec3(0.5F, 0, 0));
    EXPECT_LT(distance(edge.direction, normalize(glm::vec3(1.5F, 0, -4))), 1e-6F);
}

TEST(Distributed, penumbras_have_the_light_of_what_is_seen_of_the_lamp)
{
    const StillLife scene = penumbra_scene();
    const std::vector<PenumbraQuestion> questions = penumbra_questions();
    const auto check = [&](std::size_t i, const AreaLamp& seen) {
        const PenumbraQuestion& question = questions[i];
        Random random(20273);
        const Mean found = mean_of(samples_for_tests(40000), [&] {
            return glm::vec3(lamp_light(scene, question.at, question.lamp, question.time, 4, random));
        });
        const double exact = form_factor(glm::dvec3(question.at.position), glm::dvec3(question.at.normal), seen);
        expect_mean(found, glm::dvec3(exact), question.name);
    };
    const AreaLamp over = scene.lamps()[0];
    AreaLamp right_half = over;
    right_half.corner.x = 0;
    right_half.edge_a.x = 0.5F;
    check(0, over);
    check(2, right_half);
    check(6, over);
    check(7, over);
    check(10, scene.lamps()[1]);
    AreaLamp above_horizon = over;
    above_horizon.corner.x = 0.2F;
    above_horizon.edge_a.x = 0.3F;
    check(13, above_horizon);
    for (const std::size_t dark : {std::size_t{4}, std::size_t{8}, std::size_t{9}}) {
        const PenumbraQuestion& question = questions[dark];
        Random random(1);
        EXPECT_EQ(lamp_light(scene, question.at, question.lamp, question.time, 100, random), 0) << question.name;
    }
}

// The edge of a half-plane, seen by a lens: of each place, the share of the disc from which it is seen has a closed
// form, and the rest is an integral over the pixel.
TEST(Distributed, edges_out_of_focus_have_their_exact_light)
{
    for (const PixelQuestion& question : mean_pixels()) {
        const bool upright = question.name == "an edge out of focus";
        if (!upright && question.name != "a level edge before the focus") continue;
        const LensCamera& camera = question.camera;
        const double depth = upright ? 5 : 1;
        const double blur = std::abs(1 - depth / camera.focus_depth) * camera.lens_radius;
        double share = 0;
        constexpr int steps = 100000;
        for (int i = 0; i < steps; ++i) {
            const double place = (upright ? question.pixel.x : question.pixel.y) + (i + 0.5) / steps;
            const double along = camera.half_height * (2 * place / 8 - 1) * (upright ? 1 : -1);
            const double reached = (upright ? camera.eye.x : camera.eye.y) + depth * along;
            share += disc_beyond(-reached / blur) / steps;
        }
        expect_mean(pixel_mean(question, 20274, samples_for_tests(100000)),
                    share * glm::dvec3(1, 0.5, 2) + (1 - share) * glm::dvec3(0.1F), question.name);
    }
}

// Places and times on a fine grid.
TEST(Distributed, a_ball_that_flies_by_has_its_exact_light)
{
    for (const PixelQuestion& question : mean_pixels()) {
        if (question.name != "a ball that flies by" && question.name != "a ball that comes late") continue;
        const bool late = question.name == "a ball that comes late";
        const LensCamera& camera = question.camera;
        constexpr int places = 60;
        constexpr int times = 1500;
        double hits = 0;
        for (int i = 0; i < places; ++i)
            for (int j = 0; j < places; ++j) {
                const double x = 0.5 * (2 * (question.pixel.x + (i + 0.5) / places) / 8 - 1);
                const double y = -0.5 * (2 * (question.pixel.y + (j + 0.5) / places) / 8 - 1);
                const glm::dvec3 direction = normalize(glm::dvec3(x, y, -1));
                for (int k = 0; k < times; ++k) {
                    const double time =
                        camera.shutter_opens + (k + 0.5) / times * double(camera.shutter_closes - camera.shutter_opens);
                    const glm::dvec3 centre((late ? -2.0 : -1.2) + 2 * time, 0.1F, -4);
                    hits += length(cross(centre, direction)) < (late ? 0.6F : 0.5F) ? 1 : 0;
                }
            }
        const double share = hits / places / places / times;
        expect_mean(pixel_mean(question, 20275, samples_for_tests(100000)),
                    share * glm::dvec3(2, 1, 0.5) + (1 - share) * glm::dvec3(0.05F), question.name);
    }
}
