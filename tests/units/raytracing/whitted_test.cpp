#include <gtest/gtest.h>

#include <raytracing/whitted/questions.hpp>

using namespace umbral;
using namespace umbral::raytracing;
using namespace umbral::raytracing::whitted;

namespace {

void expect_near(const glm::vec3& got, const glm::vec3& expected, float tolerance, const std::string& what)
{
    EXPECT_LE(distance(got, expected), tolerance)
        << what << ": got " << got.x << ", " << got.y << ", " << got.z << ", expected " << expected.x << ", "
        << expected.y << ", " << expected.z;
}

Material only_glass(float index)
{
    Material glass;
    glass.refracted = 1;
    glass.index = index;
    return glass;
}

glm::vec3 white_sky(const glm::vec3&) { return glm::vec3(1); }

}

TEST(Whitted, known_answers_of_the_statement)
{
    const lighting::Material red{{}, {0.125F, 0, 0}, {0.5F, 0.25F, 0}, {}, 1};
    expect_near(direct_light(red, {0, 0, 1}, {0, 0, 1}, {0.6F, 0, 0.8F}), {0.525F, 0.2F, 0}, 1e-6F, "matt");

    Material mirror;
    mirror.local.emission = glm::vec3(1);
    mirror.mirrored = 0.5F;
    BuiltWorld world;
    world.levels = 3;
    for (const float x : {-1.0F, 1.0F}) world.panels.push_back({{x, -1, -1}, {0, 2, 0}, {0, 0, 2}, mirror});
    expect_near(light_along(world, {{0, 0.1F, 0.2F}, {1, 0, 0}}, 1), glm::vec3(1.75F), 1e-6F, "two mirrors");
    EXPECT_EQ(world.take_rays(), 3U);

    const Look pane{{}, {1, {0, 0, 0}, {0, 1, 0}, {0, 0}, only_glass(1.5F)}, {0.6F, 0.8F, 0}, 1};
    expect_near(light_towards(pane.world, pane.hit, pane.v, 1), coloured_sky({-0.4F, -0.916515F, 0}), 1e-5F, "glass");
}

// In double, with the angle between the viewer and where a mirror would send the light: the header's guarantee.
TEST(Whitted, direct_light_keeps_its_guarantee)
{
    constexpr std::uint64_t seed = 61007;
    Random random(seed);
    for (int i = 0; i < 100'000; ++i) {
        lighting::Material material = matt(random).local;
        material.shininess = random.uniform(1, 100);
        const glm::vec3 normal = random.unit_vector();
        const glm::vec3 v = random.unit_vector();
        const glm::vec3 l = normalize(glm::reflect(-v, normal) + 0.15F * random.in_cube());
        const glm::dvec3 n = normalize(glm::dvec3(normal));
        const glm::dvec3 to_light = normalize(glm::dvec3(l));
        glm::dvec3 expected(material.ambient);
        if (dot(n, to_light) > 0) {
            const double cosine = dot(glm::reflect(-to_light, n), normalize(glm::dvec3(v)));
            expected += dot(n, to_light) * glm::dvec3(material.diffuse);
            if (cosine > 0)
                expected += std::exp(double{material.shininess} * std::log(cosine)) * glm::dvec3(material.specular);
        }
        ASSERT_LE(distance(glm::dvec3(direct_light(material, normal, v, l)), expected), 1e-4)
            << "seed " << seed << ", light " << i;
    }
}

// The light that comes back from two facing mirrors is a geometric series.
TEST(Whitted, facing_mirrors_send_a_geometric_series)
{
    constexpr std::uint64_t seed = 61001;
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        Material mirror;
        mirror.local.emission = random_color(random);
        mirror.mirrored = random.uniform(0.1F, 0.9F);
        mirror.mirrored_color = random_color(random);
        BuiltWorld world;
        world.levels = 1 + static_cast<int>(random.below(12));
        for (const float x : {-1.0F, 1.0F}) world.panels.push_back({{x, -1, -1}, {0, 2, 0}, {0, 0, 2}, mirror});
        const int level = 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(world.levels)));
        const glm::dvec3 ratio = double{mirror.mirrored} * glm::dvec3(mirror.mirrored_color);
        const glm::dvec3 power = pow(ratio, glm::dvec3(world.levels - level + 1));
        const glm::dvec3 sum = glm::dvec3(mirror.local.emission) * (1.0 - power) / (1.0 - ratio);
        expect_near(light_along(world, {{0, 0, 0}, {1, 0, 0}}, level), glm::vec3(sum), 2e-5F,
                    "seed " + std::to_string(seed) + ", corridor " + std::to_string(i));
    }
}

// Where k_ps + k_t = 1 and the sky is white no light is lost, but for rays beyond the highest level: half of it leaves
// the ball at each.
TEST(Whitted, a_ball_in_a_furnace_loses_what_the_last_level_holds)
{
    constexpr std::uint64_t seed = 61002;
    Random random(seed);
    for (int i = 0; i < 100; ++i) {
        Material glass = only_glass(random.uniform(1.05F, 2));
        glass.refracted = glass.mirrored = 0.5F;
        BuiltWorld world;
        world.sky = white_sky;
        world.levels = 1 + static_cast<int>(random.below(8));
        world.balls.push_back({{0, 0, 0}, 1, glass});
        const glm::vec3 way = random.unit_vector();
        const glm::vec3 aside(0.95 * random.uniform_double() * perpendicular_to(glm::dvec3(way), random));
        const float expected = 1 - std::exp2(1 - static_cast<float>(world.levels));
        expect_near(light_along(world, {aside - 3.0F * way, way}, 1), glm::vec3(expected), 1e-6F,
                    "seed " + std::to_string(seed) + ", ray " + std::to_string(i));
    }
}

// A ray at distance b from the centre of a unit ball is turned by 2 (asin b - asin(b / index)).
TEST(Whitted, a_glass_ball_turns_rays_by_the_angle_that_trigonometry_says)
{
    constexpr std::uint64_t seed = 61003;
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        BuiltWorld world;
        world.levels = 3;
        world.balls.push_back({{0, 0, 0}, 1, only_glass(random.uniform(1.05F, 2.2F))});
        const glm::dvec3 way(random.unit_vector());
        const glm::dvec3 side = perpendicular_to(normalize(way), random);
        const double b = 0.95 * random.uniform_double();
        const double turn = 2 * (std::asin(b) - std::asin(b / double{world.balls[0].material.index}));
        const glm::dvec3 leaves = std::cos(turn) * way - std::sin(turn) * side;
        expect_near(light_along(world, {glm::vec3(b * side - 3.0 * way), glm::vec3(way)}, 1),
                    coloured_sky(glm::vec3(leaves)), 2e-5F,
                    "seed " + std::to_string(seed) + ", ray " + std::to_string(i));
    }
}

// GLM's reflect and refract as oracles, with the sky as a compass.
TEST(Whitted, mirrors_and_refracts_as_glm_does)
{
    constexpr std::uint64_t seed = 61004;
    Random random(seed);
    int total = 0;
    for (int i = 0; i < 3000; ++i) {
        Look look = interface_of_glass(random, 0);
        look.level = 1;
        look.hit.material.mirrored = random.uniform(0.2F, 0.9F);
        const Material& material = look.hit.material;
        const bool inside = dot(look.hit.normal, look.v) < 0;
        const glm::dvec3 n(inside ? -look.hit.normal : look.hit.normal);
        const double q = inside ? double{material.index} : 1 / double{material.index};
        const glm::dvec3 t = glm::refract(-glm::dvec3(look.v), n, q);
        const glm::vec3 r(glm::reflect(-glm::dvec3(look.v), n));
        glm::vec3 expected = material.local.emission + material.mirrored * material.mirrored_color * coloured_sky(r);
        total += t == glm::dvec3(0) ? 1 : 0;
        if (t != glm::dvec3(0)) expected += material.refracted * material.refracted_color * coloured_sky(glm::vec3(t));
        expect_near(light_towards(look.world, look.hit, look.v, 1), expected, 1e-5F,
                    "seed " + std::to_string(seed) + ", surface " + std::to_string(i));
    }
    EXPECT_GT(total, 200) << "total reflections among the 3000";
}

TEST(Whitted, light_is_linear_in_the_lights)
{
    constexpr std::uint64_t seed = 61005;
    Random random(seed);
    for (int i = 0; i < 500; ++i) {
        const Look both = many_lights(random);
        Look none = both;
        none.world.sources.clear();
        const glm::vec3 dark = light_towards(none.world, both.hit, both.v, 1);
        glm::vec3 sum = dark;
        for (const lighting::Light& light : both.world.sources) {
            Look one = none;
            one.world.sources = {light};
            sum += light_towards(one.world, both.hit, both.v, 1) - dark;
        }
        expect_near(light_towards(both.world, both.hit, both.v, 1), sum, 1e-5F,
                    "seed " + std::to_string(seed) + ", surface " + std::to_string(i));
    }
}

TEST(Whitted, nothing_is_asked_of_the_world_beyond_the_highest_level)
{
    BuiltWorld world;
    world.levels = 2;
    EXPECT_EQ(light_along(world, {}, 3), glm::vec3(0));
    EXPECT_EQ(world.take_rays(), 0U);
    EXPECT_EQ(light_along(world, {}, 2), coloured_sky({0, 0, -1}));
}

// The inputs are what their name says: each pair has one light that adds something, and one that does not.
TEST(WhittedInputs, pairs_are_lit_and_dark)
{
    constexpr std::uint64_t seed = 61006;
    Random random(seed);
    for (int kind = 0; kind < 600; ++kind) {
        std::vector<Look> looks;
        add_shadow_pair(looks, kind, random);
        int lit = 0;
        for (const Look& look : looks)
            lit += light_towards(look.world, look.hit, look.v, 3) != look.hit.material.local.emission ? 1 : 0;
        ASSERT_EQ(lit, 1) << "seed " << seed << ", pair " << kind;
    }
}
