#include <gtest/gtest.h>

#include <optional>
#include <texturing/can-and-pawns/plain.hpp>
#include <texturing/can-and-pawns/program.hpp>
#include <umbral/gl/context.hpp>

// Linked with the reference. What is expected follows from laws and GLM, or is what OpenGL itself makes of the same
// numbers by another way.

using namespace umbral;
using namespace umbral::texturing;

namespace {

class Lab4 : public testing::Test {
protected:
    Lab4()
    {
        gl::forbid_driver_threads();
        context_.emplace();
        glUseProgram(0);
    }

private:
    std::optional<gl::OffscreenContext> context_;
};

glm::vec4 eye_place_of(GLenum light)
{
    glm::vec4 place(0);
    glGetLightfv(light, GL_POSITION, value_ptr(place));
    return place;
}

void expect_near(const glm::vec3& given, const glm::vec3& expected, float distance, const char* what)
{
    EXPECT_LE(length(given - expected), distance)
        << what << ": " << given.x << ' ' << given.y << ' ' << given.z << ", expected " << expected.x << ' '
        << expected.y << ' ' << expected.z;
}

profiles::Profile circle(int points)
{
    profiles::Profile profile;
    for (int j = 0; j < points; ++j) {
        const double angle = std::numbers::pi * (static_cast<double>(j) / (points - 1) - 0.5);
        profile.emplace_back(j == 0 || j + 1 == points ? 0 : 2 * std::cos(angle), 2 * std::sin(angle));
    }
    return profile;
}

}

TEST_F(Lab4, normals_of_faces_are_unit_and_stand_on_the_edges)
{
    constexpr std::uint64_t seed = 90417;
    Random random(seed);
    const meshes::IndexedMesh mesh = patch(random, 12);
    const NormalTables tables = normals_of(mesh);
    ASSERT_EQ(tables.faces.size(), mesh.triangles.size());
    ASSERT_EQ(tables.vertices.size(), mesh.positions.size());
    for (std::size_t i = 0; i < tables.faces.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        EXPECT_NEAR(length(tables.faces[i]), 1, 1e-6) << "seed " << seed;
        EXPECT_NEAR(dot(tables.faces[i], mesh.positions[t.y] - mesh.positions[t.x]), 0, 1e-6) << "seed " << seed;
        EXPECT_NEAR(dot(tables.faces[i], mesh.positions[t.z] - mesh.positions[t.y]), 0, 1e-6) << "seed " << seed;
        EXPECT_GT(tables.faces[i].z, 0) << "counter-clockwise seen from above";
    }
}

TEST_F(Lab4, normals_of_a_ball_point_away_from_its_centre)
{
    const Revolved ball = revolve(circle(33), 65);
    const NormalTables tables = normals_of(ball.mesh);
    for (std::size_t i = 0; i < ball.mesh.positions.size(); ++i) {
        const std::size_t point = i % 33;
        if (point == 0 || point == 32) continue;  // at the poles each copy has two triangles, one without area
        expect_near(tables.vertices[i], normalize(ball.mesh.positions[i]), 0.09F, "normal");
    }
}

TEST_F(Lab4, the_last_copy_lies_on_the_first_and_has_the_other_end_of_the_texture)
{
    const Revolved can = revolve(profiles::can_side(), 49);
    const std::size_t count = profiles::can_side().size();
    for (std::size_t j = 0; j < count; ++j) {
        EXPECT_EQ(can.mesh.positions[j], can.mesh.positions[48 * count + j]);
        EXPECT_EQ(can.coordinates[j].s, 0);
        EXPECT_EQ(can.coordinates[48 * count + j].s, 1);
    }
    EXPECT_EQ(can.coordinates[count - 1].t, 1);
    const glm::vec4 turned =
        rotate(glm::mat4(1), glm::radians(7.5F * 5), {0, 1, 0}) * glm::vec4(profiles::can_side()[3], 0, 1);
    expect_near(can.mesh.positions[5 * count + 3], turned, 1e-6F, "GLM's rotation");
}

TEST_F(Lab4, directions_are_those_of_two_rotations)
{
    constexpr std::uint64_t seed = 5521;
    Random random(seed);
    for (int i = 0; i < 1000; ++i) {
        const float alpha = random.uniform(-4, 4);
        const float beta = random.uniform(-1.5F, 1.5F);
        const glm::mat4 turn = rotate(glm::mat4(1), alpha, {0, 1, 0}) * rotate(glm::mat4(1), beta, {-1, 0, 0});
        expect_near(direction(alpha, beta), turn * glm::vec4(0, 0, 1, 0), 1e-6F, "direction");
    }
}

TEST_F(Lab4, lights_in_the_world_lie_where_opengl_puts_them_by_the_view_on_its_stack)
{
    constexpr std::uint64_t seed = 77;
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
        const glm::mat4 view =
            rotate(translate(glm::mat4(1), 3.0F * random.in_cube()), random.uniform(0, 3), random.unit_vector());
        const std::array<Light, 2> lights = {
            {{.alpha = random.uniform(-3, 3), .beta = 0.3F}, {.directional = false, .position = random.in_cube()}}};
        activate_lights(lights, view);
        const glm::vec4 place = eye_place_of(GL_LIGHT1);
        expect_near(eye_place_of(GL_LIGHT0), direction(lights[0].alpha, 0.3F), 1e-6F, "fixed to the camera");
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixf(value_ptr(view));
        const glm::vec4 world(lights[1].position, 1);
        glLightfv(GL_LIGHT1, GL_POSITION, value_ptr(world));
        expect_near(place, eye_place_of(GL_LIGHT1), 1e-5F, "positional");
    }
}

TEST_F(Lab4, textures_hold_the_picture_with_its_bottom_row_first)
{
    constexpr std::uint64_t seed = 12;
    Random random(seed);
    LabTexture texture{.picture = random_picture(random, 7, 5)};
    activate_texture(texture);
    std::vector<std::uint8_t> texels(7 * 5 * 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
    for (std::size_t row = 0; row < 5; ++row)
        for (std::size_t i = 0; i < 21; ++i) EXPECT_EQ(texels[21 * row + i], texture.picture.rgb[21 * (4 - row) + i]);
}

TEST_F(Lab4, smooth_shading_shows_the_normals_of_vertices_and_flat_shading_those_of_faces)
{
    const gl::Framebuffer target(32, 32);
    light_by_normals();
    LitMesh mesh{{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}}}, {}, {}};
    mesh.normals.faces = {{1, 0, 0}};
    mesh.normals.vertices = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    for (const auto& [shading, channel] : {std::pair(Shading::flat, 0), std::pair(Shading::smooth, 2)}) {
        target.clear();
        draw(mesh, shading);
        const glm::u8vec4 pixel = target.read_pixels().at(16, 20);
        EXPECT_GT(pixel[channel], 220);
        EXPECT_LT(pixel[2 - channel], 100);
    }
}

TEST_F(Lab4, a_lambert_sphere_is_lit_as_the_formula_says)
{
    // One directional light on white: the wanted colour of a pixel is M_A S + M_D S (n·l), by hand.
    const gl::Framebuffer target(64, 64);
    LabTexture none;
    const Material white = make_materials(none, none).white;
    const std::array<Light, 1> light = {{{.color = {0.6F, 0.6F, 0.6F}, .alpha = 0.5F, .beta = 0.4F}}};
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    activate_lights(light, glm::mat4(1));
    activate_material(white);
    const glm::vec3 normal = normalize(glm::vec3(0.3F, 0.2F, 1));
    draw({{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}}}, {{normal}, {normal, normal, normal}}, {}},
         Shading::smooth);
    const float cosine = dot(normal, direction(0.5F, 0.4F));
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(target.read_pixels().at(32, 40)[channel],
                    255 * 0.6F * (white.ambient[channel] + white.diffuse[channel] * cosine), 1.5F);
}

TEST_F(Lab4, keys_turn_the_light_and_only_in_the_mode)
{
    const Session session("0.1 key X press\n0.2 key X release\n0.3 key 4 press\n0.5 key A press\n0.6 key C press\n",
                          {});
    EXPECT_TRUE(session.frame_at(0.2).earlier);
    EXPECT_TRUE(session.frame_at(0.2).looks.empty());
    const auto seen = [&](double time) {
        const LightsSeen lights = session.frame_at(time).lights;
        return glm::vec3(lights[2], lights[3], lights[4]);
    };
    expect_near(seen(0.4), direction(glm::radians(-40.0F), glm::radians(35.0F)), 1e-6F, "at first");
    expect_near(seen(0.55), direction(glm::radians(-40.0F), glm::radians(40.0F)), 1e-6F, "after A");
    expect_near(seen(0.65), direction(glm::radians(-45.0F), glm::radians(40.0F)), 1e-6F, "after C");
    EXPECT_EQ(session.frame_at(1).looks.size(), 5U) << "five things that differ in material or place";
    EXPECT_EQ(session.earlier().keys.size(), 2U) << "the X before the mode";
}

TEST_F(Lab4, the_scene_has_a_red_can_a_white_pawn_and_a_black_one_and_leaves_the_earlier_labs_alone)
{
    const Session session("0.1 key 4 press\n0.2 key 4 release\n0.3 key 4 press\n",
                          {.pictures = {0.05, 0.25, 0.4}, .pixels = 1});
    const Image scene = session.frame_at(0.25).picture;
    const auto at = [&](int x, int y) { return glm::ivec3(scene.at(x, y)); };
    EXPECT_EQ(at(5, 5), glm::ivec3(19, 22, 29)) << "background";
    const auto project = [&](const glm::vec3& place) {
        const glm::vec4 clip = session.earlier().projection(4.0F / 3) * session.earlier().view() * glm::vec4(place, 1);
        return glm::ivec2(320 + 320 * clip.x / clip.w, 240 - 240 * clip.y / clip.w);
    };
    const glm::ivec2 white = project(lab4::pawns[1] + glm::vec3(0, 0.967F, 0));
    const glm::ivec2 black = project(lab4::pawns[2] + glm::vec3(0, 0.967F, 0));
    EXPECT_GT(at(white.x, white.y).g, 120);
    EXPECT_LT(at(black.x, black.y).g, 110);
    const Image before = session.frame_at(0.05).picture;
    EXPECT_EQ(session.frame_at(0.4).picture.cells, before.cells);
    EXPECT_NE(scene.cells, before.cells);
}
