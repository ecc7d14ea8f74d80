#include <gtest/gtest.h>

#include <raytracing/sphere-tracing/bodies.hpp>

using namespace umbral;
using namespace umbral::raytracing;
using namespace umbral::raytracing::sdf;

namespace {

std::string text_of(const glm::vec3& p)
{
    return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) + ")";
}

/// Does p belong to the sponge? By its definition: no level takes the cube away in which p lies.
bool in_sponge(const glm::dvec3& p, int level)
{
    glm::dvec3 q = 0.5 * p + 0.5;
    if (any(lessThan(q, glm::dvec3(0))) || any(greaterThan(q, glm::dvec3(1)))) return false;
    for (int k = 0; k < level; ++k) {
        q = 3.0 * (q - floor(q));
        int in_the_middle = 0;
        for (int axis = 0; axis < 3; ++axis) in_the_middle += q[axis] > 1 && q[axis] < 2 ? 1 : 0;
        if (in_the_middle >= 2) return false;
    }
    return true;
}

}

TEST(SphereTracing, known_answers_of_the_statement)
{
    EXPECT_FLOAT_EQ(box_distance({4, 6, 0}, {1, 2, 3}), 5);
    EXPECT_FLOAT_EQ(box_distance({0.5F, 0, 0}, {1, 2, 3}), -0.5F);
    EXPECT_FLOAT_EQ(torus_distance({6, 4, 0}, 3, 1), 4);
    EXPECT_FLOAT_EQ(capsule_distance({8, 0, 4}, {1, 0, 0}, {5, 0, 0}, 1), 4);
    EXPECT_FLOAT_EQ(menger_distance({0, 0, 0}, 0), -1);
    EXPECT_FLOAT_EQ(menger_distance({0, 0, 0}, 1), 1.0F / 3);
    const Bodies ground{half_space({0, 1, 0}, 0)};
    const auto hit = sphere_trace({{0, 3, 0}, {0, -2, 0}}, ground, {1e-4F, 2});
    ASSERT_TRUE(hit.has_value());
    EXPECT_FLOAT_EQ(hit->t, 1.5F);
    EXPECT_FALSE(sphere_trace({{0, 3, 0}, {0, -2, 0}}, ground, {1e-4F, 1}).has_value());
}

// Against many points of the surface: none is nearer than the distance says, and one is nearly as near.
TEST(SphereTracing, distances_are_those_of_the_nearest_of_many_points)
{
    constexpr std::uint64_t seed = 63001;
    Random random(seed);
    const glm::vec3 half(0.7F, 1.1F, 0.4F);
    const glm::vec3 a(-0.5F, 0.2F, 0.6F);
    const glm::vec3 b(0.8F, -0.3F, -0.4F);
    struct Body {
        const char* name;
        DistanceFunction distance;
        std::vector<glm::vec3> surface;
    };
    std::vector<Body> bodies = {
        {"box", [&](const glm::vec3& p) { return box_distance(p, half); }, {}},
        {"torus", [](const glm::vec3& p) { return torus_distance(p, 1.2F, 0.4F); }, {}},
        {"capsule", [&](const glm::vec3& p) { return capsule_distance(p, a, b, 0.3F); }, {}},
    };
    constexpr int n = 160;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
            const glm::vec2 uv = glm::vec2(i, j) / static_cast<float>(n);
            for (int axis = 0; axis < 3; ++axis)
                for (const float side : {-1.0F, 1.0F}) {
                    glm::vec3 p;
                    p[axis] = side;
                    p[(axis + 1) % 3] = 2 * uv.x - 1;
                    p[(axis + 2) % 3] = 2 * uv.y - 1;
                    bodies[0].surface.push_back(p * half);
                }
            const glm::vec2 turn = 6.2831853F * uv;
            const float ring = 1.2F + 0.4F * std::cos(turn.y);
            bodies[1].surface.emplace_back(ring * std::cos(turn.x), 0.4F * std::sin(turn.y), ring * std::sin(turn.x));
        }
    // Balls along the segment: what is inside of others is too near to none of the points outside.
    for (int i = 0; i < 200'000; ++i)
        bodies[2].surface.push_back(mix(a, b, random.uniform()) + 0.3F * random.unit_vector());
    for (const Body& body : bodies)
        for (int i = 0; i < 40; ++i) {
            const glm::vec3 p = 2.0F * random.in_cube();
            const float got = body.distance(p);
            if (body.name == std::string("capsule") && got < 0) continue;
            float nearest = endless;
            for (const glm::vec3& q : body.surface) nearest = std::min(nearest, distance(p, q));
            EXPECT_LE(std::abs(got), nearest + 1e-5F) << body.name << " at " << text_of(p) << ", seed " << seed;
            EXPECT_GE(std::abs(got), nearest - 0.03F) << body.name << " at " << text_of(p) << ", seed " << seed;
        }
}

// The nearest point in double: the header's guarantee.
TEST(SphereTracing, distances_are_right_to_a_millionth_of_the_largest_length)
{
    constexpr std::uint64_t seed = 63004;
    Random random(seed);
    for (int i = 0; i < 100'000; ++i) {
        const glm::vec3 p = 10.0F * random.in_cube();
        const double largest = 10;
        const glm::vec3 half = 5.0F + 5.0F * random.in_cube();
        const glm::dvec3 nearest = clamp(glm::dvec3(p), -glm::dvec3(half), glm::dvec3(half));
        if (nearest != glm::dvec3(p)) {
            ASSERT_NEAR(box_distance(p, half), distance(glm::dvec3(p), nearest), 1e-6 * largest) << "seed " << seed;
        }
        const double longitude = std::atan2(double{p.z}, double{p.x});
        const glm::dvec3 on_circle = double{half.x} * glm::dvec3(std::cos(longitude), 0, std::sin(longitude));
        ASSERT_NEAR(torus_distance(p, half.x, 0.5F), distance(glm::dvec3(p), on_circle) - 0.5, 1e-6 * largest)
            << "seed " << seed;
        const glm::vec3 a = 10.0F * random.in_cube();
        const glm::vec3 b = 10.0F * random.in_cube();
        // The segment's nearest point by thirds: no projection.
        double low = 0;
        double high = 1;
        const auto at = [&](double s) { return distance(glm::dvec3(p), mix(glm::dvec3(a), glm::dvec3(b), s)); };
        for (int step = 0; step < 60; ++step) {
            const double third = (high - low) / 3;
            if (at(low + third) < at(high - third))
                high -= third;
            else
                low += third;
        }
        ASSERT_NEAR(capsule_distance(p, a, b, 1), at((low + high) / 2) - 1, 1e-6 * largest) << "seed " << seed;
    }
}

// The sign says whether a point belongs to the sponge, and within the distance all points do, or none.
TEST(SphereTracing, the_sponge_holds_what_its_definition_says)
{
    constexpr std::uint64_t seed = 63002;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 p = 1.3F * random.in_cube();
        const int level = static_cast<int>(random.below(5));
        const float d = menger_distance(p, level);
        if (std::abs(d) < 1e-5F) continue;
        ASSERT_EQ(d < 0, in_sponge(glm::dvec3(p), level)) << text_of(p) << ", level " << level << ", seed " << seed;
        if (d < 0) continue;
        for (int j = 0; j < 20; ++j) {
            const glm::dvec3 q = glm::dvec3(p) + 0.999 * double{d} * glm::dvec3(random.unit_vector());
            ASSERT_FALSE(in_sponge(q, level)) << text_of(p) << ", level " << level << ", seed " << seed;
        }
    }
}

// Balls have an exact answer: the quadratic equation's.
TEST(SphereTracing, balls_are_met_where_the_quadratic_says)
{
    constexpr std::uint64_t seed = 63003;
    Random random(seed);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const Balls all = random_balls(random, 1 + static_cast<int>(random.below(6)));
        const Ray ray = clear_ray(all, random);
        double expected = std::numeric_limits<double>::infinity();
        for (const glm::vec4& ball : all.balls) {
            const glm::dvec3 to = glm::dvec3(ball) - glm::dvec3(ray.origin);
            const double middle = dot(to, glm::dvec3(ray.direction));
            const double rest = double{ball.w} * double{ball.w} - dot(to, to) + middle * middle;
            if (rest > 0) expected = std::min(expected, middle - std::sqrt(rest));
        }
        const auto got = sphere_trace(ray, all.bodies(), {1e-4F, 400});
        ASSERT_EQ(got.has_value(), std::isfinite(expected)) << "seed " << seed << ", ray " << i;
        if (!got) continue;
        ++hits;
        ASSERT_NEAR(got->t, expected, 1e-3) << "seed " << seed << ", ray " << i;
        ASSERT_LE(double{got->t}, expected + 1e-4) << "before, or not farther beyond than the tolerance";
    }
    EXPECT_GT(hits, 1500);
}

TEST(SphereTracing, as_many_points_are_looked_at_as_there_may_be)
{
    for (const int steps : {0, 1, 2, 17}) {
        int asked = 0;
        const Bodies bodies{[&](const glm::vec3&) {
            ++asked;
            return 0.5F;
        }};
        EXPECT_FALSE(sphere_trace({}, bodies, {0.25F, steps}).has_value());
        EXPECT_EQ(asked, steps);
    }
}

TEST(SphereTracing, rays_that_begin_inside_go_forward)
{
    const auto out = sphere_trace({{0, 0, 0.5F}, {0, 0, 1}}, Bodies{ball_at({0, 0, 0}, 1)}, {1e-4F, 64});
    ASSERT_TRUE(out.has_value());
    EXPECT_NEAR(out->t, 0.5F, 2e-4F);
    // The second ball's surface lies within the first: it is none of the union's.
    const auto both =
        sphere_trace({{0, 0, 0}, {0, 0, 1}}, Bodies{ball_at({0, 0, 0}, 2), ball_at({0, 0, 0.5F}, 0.5F)}, {1e-4F, 64});
    ASSERT_TRUE(both.has_value());
    EXPECT_NEAR(both->t, 2, 2e-4F);
    EXPECT_EQ(both->object, 0U);
}
