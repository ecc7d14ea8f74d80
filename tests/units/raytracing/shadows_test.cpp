#include <gtest/gtest.h>

#include <glm/gtx/intersect.hpp>
#include <raytracing/shadows/scenes.hpp>

using namespace umbral;
using namespace umbral::raytracing;

// Linked with the reference. Whether light arrives is known by how the inputs are made.

namespace {

const ShadedPoint ground{{0, 0, 0}, {0, 1, 0}, 1e-6F};
const ShadowBall above{{0, 3, 0}, 1};

/// Of each pair one point has light: what is in the way of the other is the only difference.
void expect_pairs(const std::vector<LightQuestion>& questions, const std::string& what)
{
    for (std::size_t i = 0; i < questions.size(); i += 2) {
        const auto sees = [](const LightQuestion& q) { return sees_light(q.point, q.light, q.casters); };
        ASSERT_NE(sees(questions[i]), sees(questions[i + 1])) << what << ", pair " << i / 2;
    }
}

}

TEST(Shadows, what_is_between_the_point_and_the_light_casts_a_shadow)
{
    EXPECT_TRUE(sees_light(ground, {0, 5, 0, 1}, {}));
    EXPECT_FALSE(sees_light(ground, {0, 5, 0, 1}, {{above}, {}}));
    EXPECT_FALSE(sees_light(ground, {0, 0.125F, 0, 0}, {{above}, {}})) << "a sun";
    EXPECT_TRUE(sees_light(ground, {0, 1.5F, 0, 1}, {{above}, {}})) << "beyond the lamp";
    EXPECT_TRUE(sees_light(ground, {0, 5, 0, 1}, {{{{0, -3, 0}, 1}}, {}})) << "behind the point";
    EXPECT_FALSE(sees_light(ground, {0, 5, 0, 1}, {{}, {{{-1, 2, -1}, {1, 2, -1}, {0, 2, 1}}}}));
}

TEST(Shadows, a_surface_that_is_turned_away_has_no_light)
{
    EXPECT_FALSE(sees_light(ground, {0, -5, 0, 1}, {}));
    EXPECT_FALSE(sees_light(ground, {0, -5, 0, 0}, {}));
    EXPECT_FALSE(sees_light(ground, {5, -0.01F, 0, 0}, {}));
    EXPECT_TRUE(sees_light(ground, {5, 0.01F, 0, 0}, {}));
}

// The interface's own functions against GLM's, in double.
TEST(Shadows, meets_agrees_with_glm)
{
    constexpr std::uint64_t seed = 24001;
    Random random(seed);
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", ray " + std::to_string(i));
        const glm::vec3 from = 3.0F * random.in_cube();
        const Ray ray{from, normalize(2.0F * random.in_cube() - from)};
        const glm::dvec3 origin(ray.origin);
        const glm::dvec3 direction = normalize(glm::dvec3(ray.direction));
        const ShadowBall ball{2.0F * random.in_cube(), random.uniform(0.2F, 1)};
        const ShadowTriangle triangle{2.0F * random.in_cube(), 2.0F * random.in_cube(), 2.0F * random.in_cube()};
        double t = 0;
        const glm::dvec3 centre(ball.centre);
        const bool inside = distance(origin, centre) < double{ball.radius};
        const bool met = glm::intersectRaySphere(origin, direction, centre, double{ball.radius} * ball.radius, t);
        ASSERT_EQ(meets(ball, ray), met || inside);
        glm::dvec2 place(0);
        const bool crossed = glm::intersectRayTriangle(origin, direction, glm::dvec3(triangle.a),
                                                       glm::dvec3(triangle.b), glm::dvec3(triangle.c), place, t);
        ASSERT_EQ(meets(triangle, ray), crossed && t > 0);
        hits += met ? 1 : 0;
    }
    EXPECT_GT(hits, 1000);
}

TEST(Shadows, interval_ends_what_is_met)
{
    const Ray ray{{0, 0, 0}, {0, 2, 0}};
    EXPECT_TRUE(meets(above, ray));
    EXPECT_FALSE(meets(above, Ray{ray.origin, ray.direction, 0, 1})) << "met at t = 1 and 2";
    EXPECT_TRUE(meets(above, Ray{ray.origin, ray.direction, 1, 3}));
    EXPECT_FALSE(meets(above, Ray{ray.origin, ray.direction, 2}));
    EXPECT_FALSE(meets(above, Ray{ray.origin, {0, 0, 0}}));
}

// What the interface says of a point's error holds of every input, for the surface as it is recorded.
TEST(Shadows, points_lie_within_their_errors)
{
    constexpr std::uint64_t seed = 24005;
    Random random(seed);
    for (int i = 0; i < 50'000; ++i) {
        const double away = std::pow(10.0, 7 * random.uniform_double());
        const SurfaceSite site = random_site(random, static_cast<float>(away) * random.unit_vector(), 0.25 * away);
        if (site.own.balls.empty()) continue;
        const glm::dvec3 from_centre = glm::dvec3(site.rounded.position) - glm::dvec3(site.own.balls[0].centre);
        const glm::dvec3 outwards(site.rounded.normal);
        const double reach = double{site.rounded.error} * dot(abs(outwards), glm::dvec3(1));
        ASSERT_GT(length(from_centre) - double{site.own.balls[0].radius}, -reach) << "seed " << seed << ", site " << i;
    }
}

// The header's guarantee: no surface shades itself, and nothing is passed by that is 16 errors away.
TEST(Shadows, reference_keeps_its_guarantee_at_all_scales)
{
    for (const std::uint64_t seed : {24002U, 24003U, 24004U}) {
        Random random(seed);
        const std::string suffix = ", seed " + std::to_string(seed);
        for (const double size : {1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6}) {
            expect_pairs(light_pairs(random, size, 4 * size, 500), "size " + std::to_string(size) + suffix);
            expect_pairs(contact_pairs(random, size, 4 * size, 500), "contact, size " + std::to_string(size) + suffix);
        }
        for (const double away : {1e0, 1e1, 1e3, 1e5, 1e7}) {
            expect_pairs(light_pairs(random, 1e-3 * away, away, 500), "away " + std::to_string(away) + suffix);
            expect_pairs(contact_pairs(random, 1e-3 * away, away, 500),
                         "contact, away " + std::to_string(away) + suffix);
        }
    }
}
