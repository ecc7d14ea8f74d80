#include <cstdio>
#include <limits>
#include <pipeline/support.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>

#include "fixture.hpp"
#include "pixels.hpp"

// Which pixels Mesa covers, and which the reference of pipeline/rasterize-triangle: two rasterisers that share nothing
// but the rule.
namespace umbral::pipeline {
namespace {

using Corners = std::array<glm::vec2, 3>;

constexpr int tile = 16;  ///< pixels a side

/// Each triangle in its number plus one: red holds the low eight bits.
const char* const numbering_fragment =
    "#version 330\nout vec4 result;\n"
    "void main() { int n = gl_PrimitiveID + 1; result = vec4(n & 255, (n >> 8) & 255, n >> 16, 255) / 255.0; }\n";

/// Which triangle (its place plus one) each pixel belongs to; counts pixels that more than one covers.
struct Coverage {
    Grid<std::uint32_t> ids;
    std::size_t covered_twice = 0;
};

/// Drawn by OpenGL. Window coordinates of a framebuffer begin at its first row in memory, here as in OpenGL; that
/// OpenGL calls that row the bottom is a matter of names: "left and bottom edges" there are "left and top edges" here.
Coverage drawn(const gl::Framebuffer& target, const gl::Program& program, const std::vector<Corners>& triangles)
{
    const glm::vec2 half(0.5F * static_cast<float>(target.width()), 0.5F * static_cast<float>(target.height()));
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    for (const Corners& corners : triangles)
        for (const glm::vec2& corner : corners) {
            indices.push_back(static_cast<std::uint32_t>(positions.size()));
            positions.emplace_back(corner / half - 1.0F, 0);  // exact: sizes are powers of two
        }
    target.clear({0, 0, 0, 0});
    program.use();
    gl::Mesh(positions, {}, indices).draw(program);
    const Image picture = target.read_pixels();
    gl::check_errors("drawing triangles");
    Coverage coverage{Grid<std::uint32_t>(picture.width, picture.height)};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::uvec4 pixel(picture.at(x, picture.height - 1 - y));
            coverage.ids.at(x, y) = pixel.r | pixel.g << 8U | pixel.b << 16U;
        }
    return coverage;
}

Coverage rasterized(const std::vector<Corners>& triangles, int width, int height)
{
    Coverage coverage{Grid<std::uint32_t>(width, height)};
    std::vector<Fragment> fragments;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        fragments.clear();
        const auto vertex = [&](std::size_t k) { return WindowVertex{triangles[i][k], 0.5F, 1}; };
        rasterize_triangle({vertex(0), vertex(1), vertex(2)}, width, height, fragments);
        for (const Fragment& fragment : fragments) {
            std::uint32_t& id = coverage.ids.at(fragment.pixel.x, fragment.pixel.y);
            coverage.covered_twice += id == 0 ? 0U : 1U;
            id = static_cast<std::uint32_t>(i + 1);
        }
    }
    return coverage;
}

/// From a point to the nearest of the lines through a triangle's sides.
double distance_to_edges(const Corners& corners, const glm::dvec2& point)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 from(corners[i]);
        const glm::dvec2 side = glm::dvec2(corners[(i + 1) % 3]) - from;
        nearest = std::min(nearest, std::abs(side.x * (point.y - from.y) - side.y * (point.x - from.x)) / length(side));
    }
    return nearest;
}

/// How much was drawn, and how much of it differs.
struct Comparison {
    std::size_t triangles = 0;
    std::size_t pixels = 0;
    std::size_t different = 0;

    /// Draws them in both ways; the pixels that differ.
    std::vector<glm::ivec2> add(const gl::Framebuffer& target, const gl::Program& program,
                                const std::vector<Corners>& some)
    {
        const Coverage gl = drawn(target, program, some);
        const Coverage ours = rasterized(some, target.width(), target.height());
        EXPECT_EQ(ours.covered_twice, 0U);
        triangles += some.size();
        std::vector<glm::ivec2> wrong;
        for (int y = 0; y < target.height(); ++y)
            for (int x = 0; x < target.width(); ++x) {
                pixels += ours.ids.at(x, y) != 0 ? 1U : 0U;
                if (ours.ids.at(x, y) != gl.ids.at(x, y)) wrong.emplace_back(x, y);
            }
        different += wrong.size();
        return wrong;
    }

    void report(const char* name) const
    {
        std::printf("%-44s %7zu triangles, %9zu pixels, %zu different\n", name, triangles, pixels, different);
        testing::Test::RecordProperty(name, std::to_string(different));
    }
};

/// One triangle in each tile of a picture, its corners anywhere in the tile: `corner()` gives one from its lower
/// corner's.
template <class Corner>
std::vector<Corners> tiled(int size, Corner corner)
{
    std::vector<Corners> triangles;
    for (int y = 0; y < size; y += tile)
        for (int x = 0; x < size; x += tile) {
            Corners corners{};
            for (glm::vec2& position : corners) position = glm::vec2(x, y) + corner();
            triangles.push_back(corners);
        }
    return triangles;
}

class CoverageTest : public gl::GlTest {
protected:
    static constexpr std::uint64_t seed = 20275;
    Random random{seed};
    const gl::Program program{gl::vertex_source(gl::plain_vertex), gl::fragment_source(numbering_fragment)};

    CoverageTest() { RecordProperty("seed", std::to_string(seed)); }
};

}

// Corners in halves of a pixel, where nearly everything is a tie, down to 1/256.
TEST_F(CoverageTest, corners_on_the_grid)
{
    const gl::Framebuffer target(1024, 1024);
    for (const int parts : {2, 4, 16, 256}) {
        Comparison comparison;
        for (int round = 0; round < 5; ++round)
            comparison.add(target, program, tiled(1024, [&] {
                               const float x = on_grid(random, 0, tile + 1, parts);
                               return glm::vec2(std::min(x, 16.0F),
                                                std::min(on_grid(random, 0, tile + 1, parts), 16.0F));
                           }));
        comparison.report(("corners in 1/" + std::to_string(parts) + " pixel").c_str());
        EXPECT_EQ(comparison.different, 0U) << "seed " << seed;
    }
}

// Corners in 1/16384 pixel, exact on their way through the viewport transform, so that only the rounding to 1/256 is
// compared; half of them are ties.
TEST_F(CoverageTest, corners_between_grid_points)
{
    const gl::Framebuffer target(256, 256);
    Comparison comparison;
    for (int round = 0; round < 80; ++round)
        comparison.add(target, program, tiled(256, [&] {
                           glm::vec2 corner(0);
                           for (int axis = 0; axis < 2; ++axis) {
                               const bool tie = random.below(2) == 0;
                               const float off = tie ? 0.5F / 256 : static_cast<float>(random.below(64)) / 16384;
                               corner[axis] = on_grid(random, 0, 2 * tile - 1, 2) / 2 + off;
                           }
                           return corner;
                       }));
    comparison.report("corners in 1/16384 pixel, half of them ties");
    EXPECT_EQ(comparison.different, 0U) << "seed " << seed;
}

// Large triangles, one at a time: in llvmpipe those above 128 pixels take another way through the rasteriser than small
// ones.
TEST_F(CoverageTest, large_triangles)
{
    const gl::Framebuffer target(1024, 1024);
    Comparison comparison;
    for (int i = 0; i < 60; ++i) {
        Corners corners{};
        for (glm::vec2& corner : corners) {
            corner.x = on_grid(random, 0, 1024, i % 2 == 0 ? 2 : 256);
            corner.y = on_grid(random, 0, 1024, i % 2 == 0 ? 2 : 256);
        }
        comparison.add(target, program, {corners});
    }
    comparison.report("as large as the picture");
    EXPECT_EQ(comparison.different, 0U) << "seed " << seed;
}

// Triangles that reach beyond the picture: Mesa clips them at its border, and rounds the new corners to 1/256 pixel as
// any others, which moves an edge by half of that in each coordinate at most. Only pixels whose centre lies so close to
// an edge may differ.
TEST_F(CoverageTest, corners_outside)
{
    const gl::Framebuffer target(64, 64);
    constexpr double moved = 1.01 * 1.4142136 / 512;  // a hundredth more for clipping in float
    for (const int reach : {64, 256, 1024, 4096, 16000}) {
        Comparison comparison;
        for (int i = 0; i < 600; ++i) {
            Corners corners{};
            for (glm::vec2& corner : corners) {
                corner.x = on_grid(random, -reach, reach + 64, 256);
                corner.y = on_grid(random, -reach, reach + 64, 256);
            }
            for (const glm::ivec2 pixel : comparison.add(target, program, {corners}))
                EXPECT_LE(distance_to_edges(corners, glm::dvec2(pixel) + 0.5), moved)
                    << "seed " << seed << ", pixel " << pixel.x << ", " << pixel.y;
        }
        comparison.report(("corners up to " + std::to_string(reach) + " pixels outside").c_str());
        EXPECT_LE(10'000 * comparison.different, comparison.pixels) << "seed " << seed;
    }
}

}
