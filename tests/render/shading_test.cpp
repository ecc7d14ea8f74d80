#include <gtest/gtest.h>

#include <cmath>

#include "render/software.hpp"
#include "scenes.hpp"

// The picture of a square, against rays cast at it: no matrix, no rasteriser, and everything in double.
namespace umbral::render::test {
namespace {

constexpr int side = 64;
const glm::dvec3 eye(0.4, 0.9, 3.2);

struct Seen {
    glm::dvec3 color;
    double depth;
};

/// The square y = 0 under the camera at `eye`, which looks at the origin, 50 degrees high; near 1, far 20.
glm::dvec3 direction_through(int x, int y)
{
    const glm::dvec3 forward = normalize(-eye);
    const glm::dvec3 right = normalize(cross(forward, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = cross(right, forward);
    const double reach = std::tan(25 * std::acos(-1) / 180);
    return forward + right * (reach * ((x + 0.5) / side * 2 - 1)) + up * (reach * (1 - (y + 0.5) / side * 2));
}

Seen expected(const glm::dvec3& direction, const scene::Scene& scene)
{
    const glm::dvec3 at = eye + direction * (-eye.y / direction.y);
    const glm::dvec3 n(0, 1, 0);
    const glm::dvec3 v = normalize(eye - at);
    const scene::Material& m = scene.materials[0];
    // Two stripes: left and right half.
    const glm::dvec3 texel(at.x < 0 ? scene.textures[0].first : scene.textures[0].second);
    const glm::dvec3 ambient = glm::dvec3(m.ambient) * texel;
    glm::dvec3 color = glm::dvec3(m.emission) + glm::dvec3(scene.ambient) * ambient;
    for (const scene::Light& light : scene.lights) {
        const glm::dvec3 l = normalize(light.positional ? glm::dvec3(light.where) - at : glm::dvec3(light.where));
        glm::dvec3 sum = ambient;
        if (dot(n, l) > 0) {
            const double cosine = std::max(0.0, dot(n, normalize(l + v)));
            sum += glm::dvec3(m.diffuse) * texel * dot(n, l) +
                   glm::dvec3(m.specular) * std::pow(cosine, double{m.exponent});
        }
        color += glm::dvec3(light.color) * sum;
    }
    // The window's depth of a point z in front of the camera, from the perspective's two conditions: 0 at near, 1 at
    // far.
    const double z = dot(at - eye, normalize(-eye));
    const double near = 1;
    const double far = 20;
    return {color, far * (z - near) / (z * (far - near))};
}

scene::Scene square()
{
    scene::Scene scene;
    scene.camera = {
        .eye = glm::vec3(eye), .target = {0, 0, 0}, .up = {0, 1, 0}, .fovy_degrees = 50, .near = 1, .far = 20};
    scene.ambient = {0.1F, 0.2F, 0.3F};
    scene.lights = {{.name = "sun", .positional = false, .where = {1, 2, -1}, .color = {0.5F, 0.4F, 0.3F}},
                    {.name = "lamp", .positional = true, .where = {-0.5F, 0.6F, 0.2F}, .color = {0.2F, 0.5F, 0.4F}},
                    {.name = "from below", .positional = true, .where = {0, -3, 0}, .color = {0.3F, 0.1F, 0.1F}}};
    scene.textures = {{.name = "halves",
                       .kind = scene::TextureKind::stripes,
                       .size = 2,
                       .cells = 2,
                       .first = {0.9F, 0.5F, 0.1F},
                       .second = {0.2F, 0.4F, 0.8F},
                       .bilinear = false,
                       .repeat = false}};
    scene.materials = {{.name = "all terms",
                        .emission = {0.01F, 0.02F, 0.03F},
                        .ambient = {0.2F, 0.1F, 0.3F},
                        .diffuse = {0.7F, 0.6F, 0.5F},
                        .specular = {0.5F, 0.4F, 0.6F},
                        .exponent = 20,
                        .texture = 0}};
    scene.geometries = {{"square", scene::Plane{4, 4}}};
    scene.instances = {instance("square", 0)};
    return scene;
}

TEST(Shading, is_the_model_in_double_at_every_pixel)
{
    const scene::Scene scene = square();
    const DrawList list = make_draw_list(scene, side, side);
    const Frame frame = draw_in_software(list, derive_effects(list, scene).set, side, side).frame;
    int compared = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const glm::dvec3 direction = direction_through(x, y);
            const glm::dvec3 at = eye + direction * (-eye.y / direction.y);
            const double to_edge = std::min(1 - std::abs(at.x), 1 - std::abs(at.z));
            // Vertices are rounded to 1/256 pixel: near an edge, or between the halves, that may decide.
            if (std::abs(to_edge) < 0.002 || std::abs(at.x) < 0.002) continue;
            const bool hit = direction.y < 0 && to_edge > 0;
            ASSERT_EQ(frame.ids.at(x, y) != 0, hit) << x << ", " << y;
            if (!hit) continue;
            ++compared;
            const Seen seen = expected(direction, scene);
            // The same rounding moves a point by 1/256 pixel, 0.0003 here; the highlight changes fastest, by 0.5 · 20 a
            // unit at most.
            for (int i = 0; i < 3; ++i)
                ASSERT_NEAR(frame.color.at(x, y)[i], seen.color[i], 3e-3) << x << ", " << y << ", channel " << i;
            ASSERT_NEAR(frame.depth.at(x, y), seen.depth, 1e-4) << x << ", " << y;
        }
    }
    EXPECT_GT(compared, 500);
}

TEST(Shading, is_finite_where_light_eye_and_normal_leave_no_choice)
{
    scene::Scene scene = bare();
    scene.instances = {instance("ball", 0)};
    scene.materials[0].specular = glm::vec3(1);
    scene.materials[0].exponent = 0;
    // In the eye, opposite to it, in the surface, at a vertex.
    for (const glm::vec3& where : {glm::vec3(0, 0, 4), glm::vec3(0, 0, -4), glm::vec3(0, 0, 1), glm::vec3(0, 1, 0)}) {
        scene.lights = {{.name = "lamp", .positional = true, .where = where, .color = glm::vec3(1)}};
        const DrawList list = make_draw_list(scene, 33, 33);
        for (const glm::vec4& color : draw_in_software(list, all_effects, 33, 33).frame.color.cells)
            ASSERT_TRUE(std::isfinite(color.r + color.g + color.b));
    }
}

TEST(Transforms, act_in_the_order_they_are_written)
{
    const glm::mat4 m =
        model_matrix({scene::Scale{{2, 2, 2}}, scene::Rotate{{0, 0, 5}, 90}, scene::Translate{{10, 0, 0}}});
    const glm::vec4 moved = m * glm::vec4(1, 0, 0, 1);
    EXPECT_NEAR(moved.x, 10, 1e-6);
    EXPECT_NEAR(moved.y, 2, 1e-6);
    EXPECT_EQ(model_matrix({}), glm::mat4(1));
}

TEST(Projection, puts_near_and_far_at_the_ends_of_the_depth)
{
    const scene::Camera camera{
        .eye = {}, .target = {0, 0, -1}, .up = {0, 1, 0}, .fovy_degrees = 90, .near = 2, .far = 10};
    const glm::mat4 m = projection_matrix(camera, 2);
    const glm::vec4 near = m * glm::vec4(4, 2, -2, 1);  // the corner: 45 degrees up, twice that to the right
    EXPECT_NEAR(near.x / near.w, 1, 1e-6);
    EXPECT_NEAR(near.y / near.w, 1, 1e-6);
    EXPECT_NEAR(near.z / near.w, -1, 1e-6);
    const glm::vec4 far = m * glm::vec4(0, 0, -10, 1);
    EXPECT_NEAR(far.z / far.w, 1, 1e-6);
}

TEST(Software, refuses_sizes_that_the_rasteriser_does_not_take)
{
    EXPECT_THROW((void)draw_in_software(DrawList{}, {}, 0, 5), std::invalid_argument);
    EXPECT_THROW((void)draw_in_software(DrawList{}, {}, 5, 16385), std::invalid_argument);
}

}
}
