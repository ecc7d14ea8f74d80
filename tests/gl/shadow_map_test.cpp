#include <fstream>
#include <iterator>
#include <kit/color.hpp>

#include "fixture.hpp"
#include "raytracing/shadow-map/probes.hpp"
#include "raytracing/shadow-map/scenes.hpp"

// The unit raytracing/shadow-map: its reference at the border between light and shadow, and what its bias promises of
// whole pictures: no acne on any slope, and no light behind what is nearer by more.
namespace umbral::raytracing {
namespace {

std::string text_of(const std::string& name)
{
    std::ifstream file(UMBRAL_SHADOW_MAP_REFERENCE "/" + name);
    EXPECT_TRUE(file) << name;
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Case reference()
{
    Case what{"test", Random(1), {}};
    for (const char* name : {"distances.vert", "distances.frag", "shadows.vert", "shadows.frag"})
        what.sources[name] = text_of(name);
    return what;
}

using ShadowMap = gl::GlTest;

TEST_F(ShadowMap, single_points_are_lit_or_not_as_the_formula_in_double_says)
{
    const auto shadows = compile_shadows(reference());
    for (const std::uint64_t seed : {7101U, 7102U, 7103U}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const std::vector<ShadowProbe> probes =
            probe_pairs(random, 150, {.least_cosine = 0.02, .most_cosine = 1, .band = 0.15});
        const std::vector<glm::vec3> colors = colors_of(probes, *shadows);
        for (std::size_t i = 0; i < probes.size(); ++i) {
            const ShadowProbe& probe = probes[i];
            const glm::dvec3 l = towards_light(probe.light, probe.place);
            const double cosine = std::max(0.0, dot(normalize(glm::dvec3(probe.normal)), l));
            const bool lit = probe.elsewhere < 0;  // all other texels say the opposite
            const glm::dvec3 arriving =
                glm::dvec3(probe.light.ambient) + (lit ? cosine : 0.0) * glm::dvec3(probe.light.color);
            const glm::dvec3 expected = srgb_encoded(glm::dvec3(probe.color) * arriving);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(double{colors[i][c]}, expected[c], 0.006) << "point " << i;
        }
    }
}

/// A large slope before the eye in the light of a lamp or a sun, and a map so coarse that each texel covers much of it.
ShadowScene random_slope(Random& random)
{
    ShadowScene scene;
    const glm::vec3 normal = normalize(glm::vec3(0, 0, 1) + 0.7F * random.in_cube());
    const glm::vec3 towards = normalize(normal + 1.2F * random.in_cube());
    if (random.below(2) == 0)
        scene.light = sun_from(towards, glm::vec3(0), {9, 7});
    else
        scene.light = lamp_at(8.0F * towards, random.in_cube(), 80, 1.3F);
    scene.light.texels = {static_cast<int>(8 + random.below(60)), static_cast<int>(8 + random.below(60))};
    const glm::vec3 u = normalize(cross(normal, glm::vec3(0.3F, 1, 0.1F)));
    const glm::vec3 v = cross(normal, u);
    scene.things.push_back({plain(-4.0F * u - 4.0F * v, 8.0F * u, 8.0F * v), glm::mat4(1), glm::vec3(0.9F)});
    scene.eye = {0, 0, 7};
    return scene;
}

/// The second pass after a first one of `casters`.
Image shaded(const gl::Program& distances, const gl::Program& shadows, const ShadowScene& casters,
             const ShadowScene& scene)
{
    const DistanceMap map(scene.light.texels.x, scene.light.texels.y);
    map.begin();
    draw_things(distances, casters);
    const DoubleFrame frame(64, 64, scene.background);
    shadows.set("view", glm::lookAt(scene.eye, scene.target, glm::vec3(0, 1, 0)));
    shadows.set("projection", glm::perspective(0.6F, 1.0F, 0.1F, 60.0F));
    draw_things(shadows, scene);
    return frame.large().read_pixels();
}

TEST_F(ShadowMap, no_slope_has_acne_however_coarse_the_map)
{
    const auto distances = compile_distances(reference());
    const auto shadows = compile_shadows(reference());
    for (std::uint64_t seed = 7200; seed < 7240; ++seed) {
        Random random(seed);
        const ShadowScene scene = random_slope(random);
        ShadowScene nothing = scene;
        nothing.things.clear();
        const Image with = shaded(*distances, *shadows, scene, scene);
        const Image without = shaded(*distances, *shadows, nothing, scene);
        EXPECT_EQ(with.cells, without.cells) << "seed " << seed;
    }
}

TEST_F(ShadowMap, light_leaks_under_nothing_that_is_nearer_by_more_than_two_biases)
{
    const auto distances = compile_distances(reference());
    const auto shadows = compile_shadows(reference());
    for (std::uint64_t seed = 7300; seed < 7340; ++seed) {
        Random random(seed);
        ShadowScene scene = random_slope(random);
        scene.light = sun_from(glm::vec3(scene.light.place), glm::vec3(0), {9, 7});
        scene.light.texels = {40, 30};
        // The slope again, moved towards the sun by twice what a bias can be here; only this one throws shadows.
        const glm::vec3 normal = scene.things[0].shape.normals[0];
        const glm::vec3 towards(scene.light.place);
        const double cosine = dot(glm::dvec3(normal), glm::dvec3(towards));
        if (cosine < 0.2) continue;
        ShadowProbe probe;
        probe.light = scene.light;
        const auto move = static_cast<float>(2 * allowance(probe, 1, cosine));
        ShadowScene casters = scene;
        for (glm::vec3& corner : casters.things[0].shape.positions) corner = 2.0F * corner + move * towards;
        const Image picture = shaded(*distances, *shadows, casters, scene);
        const glm::u8vec4 shade = pixel_of(0.9 * glm::dvec3(scene.light.ambient));
        for (int y = 48; y < 80; ++y)
            for (int x = 48; x < 80; ++x)
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(int{picture.at(x, y)[c]}, int{shade[c]}, 1)
                        << "seed " << seed << " at " << x << ", " << y;
    }
}

}
}
