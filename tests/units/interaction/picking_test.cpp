#include <gtest/gtest.h>

#include <interaction/pick-ids/scenes.hpp>
#include <interaction/pick-ray/clicks.hpp>
#include <optional>
#include <umbral/gl/context.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/interaction/pick_buffer.hpp>
#include <umbral/raytracing/triangle.hpp>

// Three ways to pick, each by the references of its own unit, must name the same thing.

using namespace umbral;
using namespace umbral::interaction;

namespace {

/// The camera of a view matrix that turns and moves, and the frustum of a projection matrix.
PickView view_of(const PickScene& scene, const glm::ivec2& picture)
{
    const glm::mat3 turned = transpose(glm::mat3(scene.view));
    const glm::vec3 eye = -(turned * glm::vec3(scene.view[3]));
    const glm::mat4& p = scene.projection;
    const float near_plane = p[3][2] / (p[2][2] - 1);
    const float far_plane = p[3][2] / (p[2][2] + 1);
    const glm::vec2 half = near_plane / glm::vec2(p[0][0], p[1][1]);
    const glm::vec2 middle = half * glm::vec2(p[2]);
    return {{turned[0], turned[1], turned[2], eye},
            {middle.x - half.x, middle.x + half.x, middle.y - half.y, middle.y + half.y, near_plane, far_plane},
            picture};
}

/// By the ray through the pixel's centre.
std::uint32_t by_ray(const PickScene& scene, const glm::ivec2& picture, const glm::ivec2& pixel)
{
    Ray ray = pick_ray(view_of(scene, picture), pixel);
    std::uint32_t id = 0;
    for (const PickThing& thing : scene.things) {
        if (thing.id == 0) continue;
        const PickMesh& mesh = scene.meshes[thing.mesh];
        const auto corner = [&](std::size_t i) {
            return glm::vec3(thing.model * glm::vec4(mesh.positions[mesh.indices[i]], 1));
        };
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto hit = raytracing::intersect(ray, {corner(i), corner(i + 1), corner(i + 2)});
            if (!hit) continue;
            ray.t_max = hit->t;
            id = thing.id;
        }
    }
    return id;
}

/// By OpenGL's selection mode, in a view of a hundredth of a pixel round the pixel's centre.
std::uint32_t by_buffer(const PickScene& scene, const glm::ivec2& picture, const glm::ivec2& pixel)
{
    std::vector<std::uint32_t> words(256);
    glSelectBuffer(static_cast<GLsizei>(words.size()), words.data());
    glRenderMode(GL_SELECT);
    glInitNames();
    glPushName(0);
    glMatrixMode(GL_PROJECTION);
    const glm::mat4 narrow = pick_matrix(pixel, 0.01F, picture) * scene.projection;
    glLoadMatrixf(&narrow[0][0]);
    glMatrixMode(GL_MODELVIEW);
    for (const PickThing& thing : scene.things) {
        if (thing.id == 0) continue;
        glLoadName(thing.id);
        const glm::mat4 modelview = scene.view * thing.model;
        glLoadMatrixf(&modelview[0][0]);
        glBegin(GL_TRIANGLES);
        for (const std::uint32_t i : scene.meshes[thing.mesh].indices)
            glVertex3fv(&scene.meshes[thing.mesh].positions[i][0]);
        glEnd();
    }
    const auto records = parse_selection(words, glRenderMode(GL_RENDER));
    EXPECT_TRUE(records.has_value());
    const std::optional<std::size_t> nearest = nearest_record(*records);
    return nearest ? (*records)[*nearest].names.front() : 0;
}

}

// Random clicks in windows of ten content scales, each second one where its pixel lies less than a pixel from an edge.
TEST(Picking, three_ways_name_the_same_thing)
{
    constexpr std::uint64_t seed = 46001;
    gl::forbid_driver_threads();
    const gl::OffscreenContext context;
    const gl::Framebuffer window(200, 200);
    Random random(seed);
    int clicks = 0;
    int hits = 0;
    int near_edges = 0;
    for (int i = 0; i < 20; ++i) {
        const RandomScene made = random_scene(random);
        const EdgesInPicture edges(made.scene, made.picture);
        const std::unique_ptr<IdPicker> picker = make_id_picker();
        for (int k = 0; k < 200; ++k) {
            const double scale = content_scales[random.below(static_cast<std::uint32_t>(content_scales.size()))];
            // Some anywhere, the others at things.
            const glm::ivec2 anywhere = random_pixel(made.picture, random);
            const auto target = static_cast<std::size_t>(random_up_to(static_cast<int>(made.targets.size()), random));
            const glm::ivec2 aside(random_between(-9, 9, random), random_between(-9, 9, random));
            const glm::ivec2 aimed =
                k % 4 == 0 ? anywhere : glm::clamp(made.targets[target] + aside, glm::ivec2(0), made.picture - 1);
            const Click click = click_at(inside_of(aimed, random), made.picture, glm::dvec2(scale));
            const std::optional<glm::ivec2> pixel = pick_pixel(click.cursor, click.window, click.framebuffer);
            ASSERT_EQ(pixel, aimed) << "seed " << seed;
            const double to_edge = edges.distance(aimed);
            // OpenGL rounds corners to 1/256 of a pixel.
            if (to_edge < 0.02 || (k % 2 == 0 && to_edge > 1)) continue;
            const std::uint32_t id = picker->ids_around(made.scene, made.picture, aimed, 0).at(0, 0);
            const auto where = [&] {
                return "seed " + std::to_string(seed) + ", scene " + std::to_string(i) + ", click " + std::to_string(k);
            };
            ASSERT_EQ(by_ray(made.scene, made.picture, aimed), id) << where();
            ASSERT_EQ(by_buffer(made.scene, made.picture, aimed), id) << where();
            ++clicks;
            hits += id != 0 ? 1 : 0;
            near_edges += to_edge < 1 ? 1 : 0;
        }
    }
    RecordProperty("clicks", clicks);
    RecordProperty("hits", hits);
    RecordProperty("near_edges", near_edges);
    EXPECT_GT(hits, 300);
    EXPECT_GT(near_edges, 300);
}
