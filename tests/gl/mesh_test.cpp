#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>

#include "fixture.hpp"
#include "pixels.hpp"

namespace umbral::gl {
namespace {

using Meshes = GlTest;

TEST_F(Meshes, refuse_wrong_sizes_and_indices)
{
    const std::array<glm::vec3, 3> three = {};
    const std::array<glm::vec3, 2> two = {};
    EXPECT_THROW(Mesh(three, two, std::array<std::uint32_t, 3>{0, 1, 2}), std::invalid_argument);
    EXPECT_THROW(Mesh(three, {}, std::array<std::uint32_t, 4>{0, 1, 2, 0}), std::invalid_argument);
    EXPECT_THROW(Mesh(three, {}, std::array<std::uint32_t, 3>{0, 1, 3}), std::invalid_argument);
    EXPECT_NO_THROW(Mesh({}, {}, {}));
}

// The shader chooses the places of its attributes; another program with other places must not be disturbed.
TEST_F(Meshes, follow_the_programs_own_places)
{
    const char* fragment = "#version 330\nin vec3 shade; out vec4 r; void main() { r = vec4(shade, 1.0); }\n";
    const Program usual(vertex_source("#version 330\nin vec3 position; in vec3 normal; out vec3 shade;\nvoid main() { "
                                      "shade = normal; gl_Position = vec4(position, 1.0); }\n"),
                        fragment_source(fragment));
    const Program swapped(vertex_source("#version 330\nlayout(location = 5) in vec3 position; layout(location = 0) in "
                                        "vec3 normal; out vec3 shade;\n"
                                        "void main() { shade = normal; gl_Position = vec4(position, 1.0); }\n"),
                          fragment_source(fragment));
    const std::array corners = {glm::vec3(-1, -1, 0), glm::vec3(3, -1, 0), glm::vec3(-1, 3, 0)};
    const std::array normals = {glm::vec3(0.2F, 0.4F, 0.6F), glm::vec3(0.2F, 0.4F, 0.6F), glm::vec3(0.2F, 0.4F, 0.6F)};
    const Mesh mesh(corners, normals, std::array<std::uint32_t, 3>{0, 1, 2});
    const Framebuffer target(4, 4);
    for (const Program* program : {&usual, &swapped, &usual}) {
        target.clear();
        mesh.draw(*program);
        for (const glm::u8vec4& pixel : target.read_pixels().cells) EXPECT_EQ(pixel, glm::u8vec4(51, 102, 153, 255));
    }
    EXPECT_NO_THROW(check_errors("drawing"));
}

TEST_F(Meshes, draw_their_corners_as_points)
{
    const Program program(vertex_source(plain_vertex), fragment_source(plain_fragment));
    program.set("color", glm::vec4(1));
    // Centres of pixels (0, 3) and (2, 1) of 4 x 4, top row first.
    const std::array corners = {glm::vec3(-0.75F, -0.75F, 0), glm::vec3(0.25F, 0.25F, 0), glm::vec3(0.25F, 0.25F, 0)};
    const Mesh mesh(corners, {}, std::array<std::uint32_t, 3>{0, 1, 2});
    const Framebuffer target(4, 4);
    target.clear();
    mesh.draw_points(program);
    const Image picture = target.read_pixels();
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_EQ(picture.at(x, y).r, (x == 0 && y == 3) || (x == 2 && y == 1) ? 255 : 0) << x << ", " << y;
}

TEST_F(Meshes, outlive_their_context_without_harm)
{
    auto second = std::make_unique<OffscreenContext>();
    const Mesh mesh = rectangle(-1, 1, -1, 1);
    const Framebuffer target(2, 2);
    second.reset();
    SUCCEED();
}

}
}
