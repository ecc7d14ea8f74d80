#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <umbral/core/random.hpp>
#include <umbral/gl/context.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>

#include "render/rows.hpp"
#include "render/vertex_stage.hpp"

// Which pixels random triangles in clip coordinates cover: by the engine's division, viewport and rows, by the
// reference of pipeline/rasterize-triangle, which must be the same ones, and by Mesa's. The environment variable
// UMBRAL_COVERAGE_TRIANGLES says how many to draw: 20,000 if it is not set; a million takes minutes.
namespace umbral::render::test {
namespace {

using Triangle = std::array<glm::vec4, 3>;

std::size_t triangles_wanted()
{
    const char* text = std::getenv("UMBRAL_COVERAGE_TRIANGLES");
    return text == nullptr ? 20'000 : static_cast<std::size_t>(std::strtoull(text, nullptr, 10));
}

constexpr const char* vertex_text =
    "#version 330\nlayout(location = 0) in vec4 clip;\nvoid main() { gl_Position = vec4(clip.x, -clip.y, clip.zw); }\n";
constexpr const char* fragment_text =
    "#version 330\nout vec4 result;\nvoid main() { int n = gl_PrimitiveID + 1; result = vec4(n & 255, (n >> 8) & 255, "
    "n >> 16, 255) / 255.0; }\n";

/// The number of the last triangle, from 1, that covers each pixel.
using Ids = Grid<std::uint32_t>;

class Mesa {
public:
    explicit Mesa(int side) : target_(side, side), program_({"ids.vert", vertex_text}, {"ids.frag", fragment_text})
    {
        glGenVertexArrays(1, &array_);
        glGenBuffers(1, &buffer_);
    }
    Mesa(const Mesa&) = delete;
    Mesa& operator=(const Mesa&) = delete;
    ~Mesa()
    {
        glDeleteVertexArrays(1, &array_);
        glDeleteBuffers(1, &buffer_);
    }

    Ids draw(const std::vector<Triangle>& triangles)
    {
        target_.clear({0, 0, 0, 0});
        glDisable(GL_DEPTH_TEST);
        program_.use();
        glBindVertexArray(array_);
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof(Triangle)), triangles.data(),
                     GL_STREAM_DRAW);
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * triangles.size()));
        const Image picture = target_.read_pixels();
        gl::check_errors("drawing triangles");
        Ids ids(picture.width, picture.height);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const glm::uvec4 pixel(picture.at(x, picture.height - 1 - y));
                ids.at(x, y) = pixel.r | pixel.g << 8U | pixel.b << 16U;
            }
        return ids;
    }

private:
    gl::Framebuffer target_;
    gl::Program program_;
    unsigned array_ = 0;
    unsigned buffer_ = 0;
};

/// As Mesa::draw; `twice` counts pixels that are covered again. The reference must cover the same ones.
Ids drawn_here(const std::vector<Triangle>& triangles, int side, std::size_t& twice)
{
    Ids ids(side, side);
    std::size_t unlike_the_unit = 0;
    std::vector<pipeline::Fragment> fragments;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto corner = [&](std::size_t k) { return to_window(triangles[i][k], side, side); };
        const std::array<pipeline::WindowVertex, 3> triangle = {corner(0), corner(1), corner(2)};
        fragments.clear();
        pipeline::rasterize_triangle(triangle, side, side, fragments);
        auto expected = fragments.begin();
        for_each_run(set_up(triangle, {{0, side - 1}, {0, side - 1}}), [&](int y, int first, int last) {
            for (int x = first; x <= last; ++x) {
                if (expected == fragments.end() || expected++->pixel != glm::ivec2(x, y)) ++unlike_the_unit;
                std::uint32_t& id = ids.at(x, y);
                twice += id == 0 ? 0U : 1U;
                id = static_cast<std::uint32_t>(i + 1);
            }
        });
        unlike_the_unit += static_cast<std::size_t>(fragments.end() - expected);
    }
    EXPECT_EQ(unlike_the_unit, 0U);
    return ids;
}

/// From a pixel's centre to the nearest of the lines through the triangle's sides, in pixels.
double distance_to_sides(const Triangle& triangle, int side, const glm::ivec2& pixel)
{
    std::array<glm::dvec2, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = (glm::dvec2(triangle[i]) / double{triangle[i].w} * glm::dvec2(1, -1) + 1.0) * 0.5 * double(side);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 along = corners[(i + 1) % 3] - corners[i];
        const glm::dvec2 to = glm::dvec2(pixel) + 0.5 - corners[i];
        nearest = std::min(nearest, std::abs(along.x * to.y - along.y * to.x) / length(along));
    }
    return nearest;
}

struct Tally {
    std::size_t triangles = 0, pixels = 0, twice = 0;
    std::size_t only_here = 0, only_mesa = 0, other_triangle = 0;
    double farthest = 0;  ///< of a differing pixel's centre from a side, in pixels

    [[nodiscard]] std::size_t different() const { return only_here + only_mesa + other_triangle; }

    void add(Mesa& mesa, const std::vector<Triangle>& some, int side)
    {
        triangles += some.size();
        const Ids theirs = mesa.draw(some);
        const Ids ours = drawn_here(some, side, twice);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const std::uint32_t a = ours.at(x, y);
                const std::uint32_t b = theirs.at(x, y);
                pixels += a != 0 ? 1U : 0U;
                if (a == b) continue;
                ++(b == 0 ? only_here : a == 0 ? only_mesa : other_triangle);
                farthest = std::max(farthest, distance_to_sides(some.at((a != 0 ? a : b) - 1), side, {x, y}));
            }
    }

    void report(const char* name) const
    {
        std::printf(
            "%-46s %8zu triangles %10zu pixels; differ: %zu (here only %zu, Mesa only %zu, other triangle %zu), at "
            "most %.5f pixel from a side\n",
            name, triangles, pixels, different(), only_here, only_mesa, other_triangle, farthest);
    }
};

class RasterCoverage : public testing::Test {
protected:
    static constexpr std::uint64_t seed = 20601;
    Random random{seed};

    RasterCoverage()
    {
        gl::forbid_driver_threads();
        context.emplace();
        RecordProperty("seed", std::to_string(seed));
    }

    /// In clip coordinates, for a picture of `side` pixels.
    static glm::vec4 clip(const glm::vec2& pixel, int side, float w)
    {
        const glm::vec2 ndc = pixel * (2.0F / static_cast<float>(side)) - 1.0F;
        return {w * ndc.x, -w * ndc.y, 0, w};
    }

    /// One triangle in each tile of the picture, its corners anywhere in the tile.
    template <class Place>
    std::vector<Triangle> tiled(int side, int tile, const Place& place)
    {
        std::vector<Triangle> triangles;
        for (int y = 0; y < side; y += tile)
            for (int x = 0; x < side; x += tile) {
                Triangle triangle{};
                for (glm::vec4& corner : triangle) corner = place(x, y);
                triangles.push_back(triangle);
            }
        return triangles;
    }

    /// A place in a tile in multiples of 1/256 pixel: exact on its way to the window.
    glm::vec2 on_grid(int x, int y, int tile)
    {
        const auto cells = static_cast<std::uint32_t>(256 * tile + 1);
        const float right = static_cast<float>(random.below(cells)) / 256;
        return glm::vec2(x, y) + glm::vec2(right, static_cast<float>(random.below(cells)) / 256);
    }
    glm::vec2 anywhere(int x, int y, int tile)
    {
        const auto size = static_cast<float>(tile);
        const float right = random.uniform(0, size);
        return glm::vec2(x, y) + glm::vec2(right, random.uniform(0, size));
    }

    std::optional<gl::OffscreenContext> context;
};

}

// Nothing is rounded before the corners are: every pixel must be the same.
TEST_F(RasterCoverage, corners_on_the_grid)
{
    Mesa mesa(1024);
    Tally small;
    Tally large;
    while (small.triangles < triangles_wanted() * 4 / 10)
        small.add(mesa, tiled(1024, 16, [&](int x, int y) { return clip(on_grid(x, y, 16), 1024, 1); }), 1024);
    while (large.triangles < triangles_wanted() / 20)
        large.add(mesa, tiled(1024, 128, [&](int x, int y) { return clip(on_grid(x, y, 128), 1024, 1); }), 1024);
    small.report("corners in 1/256 pixel, up to 16 pixels");
    large.report("corners in 1/256 pixel, up to 128 pixels");
    EXPECT_EQ(small.different() + large.different() + small.twice + large.twice, 0U) << "seed " << seed;
}

// Corners anywhere, in perspective: division and viewport round before, here and there in the same order.
TEST_F(RasterCoverage, corners_anywhere_in_perspective)
{
    Mesa mesa(1024);
    Tally tally;
    while (tally.triangles < triangles_wanted() * 4 / 10)
        tally.add(mesa,
                  tiled(1024, 16,
                        [&](int x, int y) { return clip(anywhere(x, y, 16), 1024, std::exp2(random.uniform(-3, 6))); }),
                  1024);
    tally.report("corners anywhere, w from 1/8 to 64");
    EXPECT_EQ(tally.twice, 0U);
    // Where the divisions' last bits differ, a corner may move by 1/256 pixel.
    EXPECT_LE(100'000 * tally.different(), tally.pixels) << "seed " << seed;
    EXPECT_LE(tally.farthest, 1.5 / 256);
}

// Grids of moved corners without a gap: each pixel exactly once, and the same triangle in both. (Moved by a quarter of
// a cell, a corner would cross the diagonal, and the mesh lie on itself.)
TEST_F(RasterCoverage, meshes_cover_each_pixel_once)
{
    constexpr int side = 512;
    constexpr int cell = 8;
    constexpr int cells = side / cell;
    Mesa mesa(side);
    Tally tally;
    while (tally.triangles < triangles_wanted() / 10) {
        Grid<glm::vec4> corners(cells + 1, cells + 1);
        for (int y = 0; y <= cells; ++y)
            for (int x = 0; x <= cells; ++x) {
                const glm::vec2 moved(x % cells == 0 ? 0 : random.uniform(-1.9F, 1.9F),
                                      y % cells == 0 ? 0 : random.uniform(-1.9F, 1.9F));
                corners.at(x, y) = clip(glm::vec2(cell * x, cell * y) + moved, side, 1);
            }
        std::vector<Triangle> triangles;
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x) {
                triangles.push_back({corners.at(x, y), corners.at(x + 1, y), corners.at(x, y + 1)});
                triangles.push_back({corners.at(x + 1, y), corners.at(x, y + 1), corners.at(x + 1, y + 1)});
            }
        const std::size_t before = tally.pixels;
        tally.add(mesa, triangles, side);
        ASSERT_EQ(tally.pixels - before, std::size_t{side} * side) << "a gap, seed " << seed;
        ASSERT_EQ(tally.twice, 0U) << "seed " << seed;
    }
    tally.report("meshes without a gap");
    EXPECT_LE(100'000 * tally.different(), tally.pixels) << "seed " << seed;
    EXPECT_LE(tally.farthest, 1.5 / 256);
}

// Mesa clips what reaches beyond the picture, and rounds the corners that this makes: an edge moves by up to half of
// 1/256 pixel in x and y.
TEST_F(RasterCoverage, triangles_beyond_the_border)
{
    constexpr int side = 64;
    Mesa mesa(side);
    Tally tally;
    while (tally.triangles < triangles_wanted() / 20) {
        const float reach = std::exp2(random.uniform(5, 13));
        Triangle triangle{};
        for (glm::vec4& corner : triangle)
            corner = clip({random.uniform(-reach, reach + side), random.uniform(-reach, reach + side)}, side, 1);
        tally.add(mesa, {triangle}, side);
    }
    tally.report("corners up to 8192 pixels outside");
    EXPECT_LE(10'000 * tally.different(), tally.pixels) << "seed " << seed;
    EXPECT_LE(tally.farthest, 1.5 / 256);
}

}
