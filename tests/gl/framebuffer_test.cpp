#include <cmath>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>

#include "fixture.hpp"
#include "pixels.hpp"

namespace umbral::gl {
namespace {

using Pixels = GlTest;

constexpr glm::u8vec4 red(255, 0, 0, 255);
constexpr glm::u8vec4 blue(0, 0, 255, 255);

TEST_F(Pixels, clear_fills_every_pixel_and_the_depth)
{
    const Framebuffer target(7, 5);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 1, 1);
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    glDepthMask(GL_FALSE);
    target.clear({1, 0, 0, 1});
    const Image picture = target.read_pixels();
    EXPECT_EQ(picture.width, 7);
    EXPECT_EQ(picture.height, 5);
    for (const glm::u8vec4& pixel : picture.cells) EXPECT_EQ(pixel, red);
    for (const float depth : target.read_depth().cells) EXPECT_EQ(depth, 1);
}

// A pixel is covered if its centre lies inside: known without drawing. Edges keep away from the centres.
TEST_F(Pixels, coverage_and_row_order_are_as_computed_by_hand)
{
    const int width = 31;
    const int height = 17;
    const Framebuffer target(width, height);
    target.clear({0, 0, 1, 1});
    const Program program(vertex_source(plain_vertex), fragment_source(plain_fragment));
    program.set("color", glm::vec4(1, 0, 0, 1));
    // From pixel column 4 to 20 and, counted from the top, row 2 to 9.
    rectangle(4.0F / 31 * 2 - 1, 20.0F / 31 * 2 - 1, 1 - 9.0F / 17 * 2, 1 - 2.0F / 17 * 2).draw(program);
    const Image picture = target.read_pixels();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            EXPECT_EQ(picture.at(x, y), x >= 4 && x < 20 && y >= 2 && y < 9 ? red : blue) << x << ", " << y;
}

TEST_F(Pixels, depth_is_read_top_row_first)
{
    const Framebuffer target(8, 8);
    target.clear();
    glEnable(GL_DEPTH_TEST);
    const Program program(vertex_source(plain_vertex), fragment_source(plain_fragment));
    rectangle(-1, 1, 0, 1, -0.5F).draw(program);  // the upper half, at (1 - 0.5) / 2
    const Grid<float> depth = target.read_depth();
    EXPECT_NEAR(depth.at(3, 0), 0.25, std::ldexp(1, -23));
    EXPECT_EQ(depth.at(3, 7), 1);
}

TEST_F(Pixels, reading_does_not_trust_pixel_store_state)
{
    const Framebuffer target(5, 3);
    target.clear({1, 0, 0, 1});
    glPixelStorei(GL_PACK_ROW_LENGTH, 100);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 3);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    for (const glm::u8vec4& pixel : target.read_pixels().cells) EXPECT_EQ(pixel, red);
}

TEST_F(Pixels, fixed_function_draws_too)
{
    const Framebuffer target(16, 16);
    target.clear({0, 0, 1, 1});
    glColor3f(1, 0, 0);
    glRectf(-1, -1, 0, 1);
    const Image picture = target.read_pixels();
    EXPECT_EQ(picture.at(2, 8), red);
    EXPECT_EQ(picture.at(12, 8), blue);
}

TEST_F(Pixels, refuses_sizes_that_are_none)
{
    EXPECT_THROW(Framebuffer(0, 4), std::invalid_argument);
    EXPECT_THROW(Framebuffer(4, -1), std::invalid_argument);
    EXPECT_THROW(Framebuffer(1 << 20, 1 << 20), std::runtime_error);
}

}
}
