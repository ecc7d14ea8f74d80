#include "render/rays/bump.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <umbral/core/random.hpp>

#include "render/rays/draw.hpp"
#include "scenes.hpp"

// Normals bent by bump maps, against those of surfaces that are raised by a formula.
namespace umbral::render::rays::test {
namespace {

using render::test::bare;
using render::test::instance;

constexpr double turn = 2 * std::numbers::pi;

double height(const glm::dvec2& uv) { return 0.5 + 0.3 * std::sin(turn * uv.x) * std::cos(2 * turn * uv.y); }

/// Its derivatives by u and v.
glm::dvec2 slopes(const glm::dvec2& uv)
{
    return {0.3 * turn * std::cos(turn * uv.x) * std::cos(2 * turn * uv.y),
            -0.6 * turn * std::sin(turn * uv.x) * std::sin(2 * turn * uv.y)};
}

/// `shape` with that height field on it, once round (u, v).
scene::Scene raised(scene::Shape shape, std::vector<scene::Transform> transforms, float by)
{
    scene::Scene scene = bare();
    scene.textures = {{.name = "heights", .size = 512}};
    scene.materials[0].bump = 0;
    scene.materials[0].bump_height = by;
    scene.geometries[0].shape = std::move(shape);
    scene.instances = {instance("raised", 0, std::move(transforms))};
    return scene;
}

DrawList list_of(const scene::Scene& scene)
{
    DrawList list = make_draw_list(scene, 64, 64, true);
    Grid<glm::vec4>& texels = list.textures.at(0).texels;
    for (int y = 0; y < texels.height; ++y)
        for (int x = 0; x < texels.width; ++x) {
            const glm::dvec2 uv((x + 0.5) / texels.width, (texels.height - y - 0.5) / texels.height);
            texels.at(x, y) = glm::vec4(glm::vec3(static_cast<float>(height(uv))), 1);
        }
    return list;
}

double degrees_between(const glm::vec3& a, const glm::dvec3& b)
{
    return glm::degrees(std::atan2(length(cross(glm::dvec3(a), b)), dot(glm::dvec3(a), b)));
}

/// Normals where rays meet `scene`; `expected(uv)` in the coordinates of the shape before its transforms' linear part.
template <class Expected>
void expect_normals(const scene::Scene& scene, double tolerance, const Expected& expected)
{
    const DrawList list = list_of(scene);
    const World world = make_world(list);
    Random random(11);
    int met = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 direction(random.uniform(-0.3F, 0.3F), random.uniform(-0.3F, 0.3F), -1);
        const auto seen = look(world, {glm::vec3(0), direction});
        if (!seen) continue;
        const glm::dvec3 normal = expected(glm::dvec2(seen->uv), glm::dmat3(list.draws[0].model_view));
        // At grazing angles the normal is bent back to whoever looks.
        if (dot(normal, -glm::dvec3(normalize(direction))) < 0.1) continue;
        // At a sphere's pole its triangles are not like its texture.
        if (scene.geometries[0].shape.index() == 0 && std::abs(seen->uv.y - 0.5F) > 0.46F) continue;
        ++met;
        EXPECT_LT(degrees_between(bumped(world, *seen, direction), normal), tolerance)
            << seen->uv.x << " " << seen->uv.y;
    }
    EXPECT_GT(met, 500) << "seed 11";
}

TEST(Bump, on_a_plane_gives_the_normals_of_a_raised_plane)
{
    const std::vector<scene::Transform> transforms = {scene::Scale{{1.2F, 1, 0.7F}}, scene::Rotate{{1, 0, 0}, 60},
                                                      scene::Rotate{{0, 0, 1}, 25}};
    for (const float by : {0.2F, -0.1F}) {
        const scene::Scene scene = raised(scene::Plane{}, transforms, by);
        // Lengths of the world are what heights count: P = (x, y) + height n.
        expect_normals(scene, 0.1, [&](const glm::dvec2& uv, const glm::dmat3& linear) {
            const glm::dvec3 u = linear * glm::dvec3(2, 0, 0);
            const glm::dvec3 v = linear * glm::dvec3(0, 0, -2);
            const glm::dvec3 n = normalize(cross(u, v));
            const glm::dvec2 slope = double{by} * slopes(uv);
            return normalize(cross(u + slope.x * n, v + slope.y * n));
        });
    }
}

TEST(Bump, on_a_sphere_gives_the_normals_of_a_raised_sphere)
{
    const scene::Scene scene = raised(scene::Sphere{256, 512}, {scene::Rotate{{1, 1, 0}, 40}}, 0.05F);
    expect_normals(scene, 1, [&](const glm::dvec2& uv, const glm::dmat3& linear) {
        const double longitude = turn * uv.x;
        const double latitude = (uv.y - 0.5) * std::numbers::pi;
        const glm::dvec3 n(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                           std::cos(latitude) * std::cos(longitude));
        const glm::dvec3 u = turn * std::cos(latitude) * glm::dvec3(std::cos(longitude), 0, -std::sin(longitude));
        const glm::dvec3 v =
            std::numbers::pi * glm::dvec3(-std::sin(latitude) * std::sin(longitude), std::cos(latitude),
                                          -std::sin(latitude) * std::cos(longitude));
        const glm::dvec2 slope = 0.05 * slopes(uv);
        return linear * normalize(cross(u + slope.x * n, v + slope.y * n));
    });
}

TEST(Bump, of_a_flat_map_changes_nothing_and_of_a_back_mirrors_the_front)
{
    scene::Scene scene = raised(scene::Sphere{24, 48}, {}, 0.3F);
    scene.textures[0].first = scene.textures[0].second = glm::vec3(0.5F);
    const DrawList list = make_draw_list(scene, 32, 32, true);
    const World world = make_world(list);
    for (float x = -0.2F; x <= 0.2F; x += 0.01F) {
        const glm::vec3 direction(x, 0.07F, -1);
        const auto seen = look(world, {glm::vec3(0), direction});
        if (!seen) continue;
        EXPECT_LT(degrees_between(bumped(world, *seen, direction), glm::dvec3(seen->normal)), 1e-3) << x;
    }
    scene = raised(scene::Plane{}, {scene::Rotate{{1, 0, 0}, 90}}, 0.2F);
    scene.instances[0].sides = scene::Sides::both;
    const DrawList front = list_of(scene);
    scene.camera.eye = {0, 0, -4};
    const DrawList back = list_of(scene);
    const World before = make_world(front);
    const World behind = make_world(back);
    for (float x = -0.2F; x <= 0.2F; x += 0.01F) {
        const glm::vec3 one(x, 0.07F, -1);
        const glm::vec3 other(-x, 0.07F, -1);
        const auto of_front = look(before, {glm::vec3(0), one});
        const auto of_back = look(behind, {glm::vec3(0), other});
        ASSERT_TRUE(of_front && of_back);
        EXPECT_TRUE(of_back->from_behind);
        // Eye space is turned half round y between the two.
        const glm::dvec3 turned(bumped(before, *of_front, one) * glm::vec3(-1, 1, -1));
        EXPECT_LT(degrees_between(bumped(behind, *of_back, other), -turned), 0.1) << x;
    }
}

TEST(Bump, is_seen_in_pictures_unless_they_show_what_rasterisers_draw)
{
    const scene::Scene scene = raised(scene::Sphere{24, 48}, {}, 0.1F);
    scene::Scene plain = scene;
    plain.materials[0].bump.reset();
    const auto picture = [](const scene::Scene& of, bool local, RayCounts& counts) {
        return draw_by_rays(make_draw_list(of, 24, 24, true), 24, 24, {.local_only = local}, &counts).color.cells;
    };
    RayCounts with;
    RayCounts without;
    RayCounts local;
    EXPECT_NE(picture(scene, false, with), picture(plain, false, without));
    EXPECT_GT(with.bumped, 100U);
    EXPECT_EQ(without.bumped, 0U);
    EXPECT_EQ(picture(scene, true, local), picture(plain, true, without));
    EXPECT_EQ(local.bumped, 0U);
    EXPECT_TRUE(make_draw_list(scene, 24, 24).textures.empty()) << "only rays need the heights";
}

}
}
