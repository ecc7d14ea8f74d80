#include <gtest/gtest.h>

#include <numeric>
#include <pipeline/support.hpp>
#include <umbral/core/random.hpp>
#include <umbral/pipeline/assembly.hpp>

using namespace umbral;
using namespace umbral::pipeline;
using enum PrimitiveType;

namespace {

using Indices = std::vector<std::uint32_t>;

Indices counted(std::size_t count)
{
    Indices indices(count);
    std::iota(indices.begin(), indices.end(), 0U);
    return indices;
}

std::vector<Indices> corners_of(PrimitiveType type, std::size_t count)
{
    std::vector<Indices> result;
    for (const Primitive& primitive : assemble(type, counted(count))) result.push_back(primitive.corners);
    return result;
}

std::vector<glm::vec2> on_circle(std::size_t count)
{
    std::vector<glm::vec2> places;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
        places.emplace_back(100 * std::cos(angle), 100 * std::sin(angle));
    }
    return places;
}

}

// The lists of the course's slides.
TEST(PrimitiveAssembly, lists_of_the_course)
{
    EXPECT_EQ(corners_of(triangle_strip, 8),
              (std::vector<Indices>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}, {4, 5, 6}, {6, 5, 7}}));
    EXPECT_EQ(corners_of(quad_strip, 10),
              (std::vector<Indices>{{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 7, 6}, {6, 7, 9, 8}}));
    EXPECT_EQ(corners_of(triangle_fan, 7),
              (std::vector<Indices>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}}));
    EXPECT_EQ(corners_of(line_loop, 4), (std::vector<Indices>{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
}

TEST(PrimitiveAssembly, counts_of_the_course)
{
    for (std::size_t n = 0; n < 20; ++n) {
        const auto count = [&](PrimitiveType type) { return assemble(type, counted(n)).size(); };
        const auto beyond = [&](std::size_t k) { return n > k ? n - k : 0; };
        EXPECT_EQ(count(points), n);
        EXPECT_EQ(count(lines), n / 2);
        EXPECT_EQ(count(line_strip), beyond(1));
        EXPECT_EQ(count(line_loop), n < 3 ? 0 : n);
        EXPECT_EQ(count(triangles), n / 3);
        EXPECT_EQ(count(triangle_strip), beyond(2));
        EXPECT_EQ(count(triangle_fan), beyond(2));
        EXPECT_EQ(count(quads), n / 4);
        EXPECT_EQ(count(quad_strip), beyond(2) / 2);
        EXPECT_EQ(count(polygon), n < 3 ? 0U : 1U);
    }
}

// A strip in zigzag: all its faces show the same side. So do those of a fan and of a quad strip.
TEST(PrimitiveAssembly, faces_of_a_strip_show_the_same_side)
{
    std::vector<glm::vec2> zigzag;
    for (int i = 0; i < 12; ++i) zigzag.emplace_back(10 * (i / 2) + 5 * (i % 2), i % 2 == 0 ? 10 : 0);
    for (const PrimitiveType type : {triangle_strip, quad_strip})
        for (const Primitive& face : assemble(type, counted(zigzag.size()))) {
            std::vector<glm::vec2> places;
            for (const std::uint32_t corner : face.corners) places.push_back(zigzag[corner]);
            EXPECT_EQ(is_front_facing(places), true) << static_cast<int>(type) << ' ' << face.corners[0];
        }
}

TEST(PrimitiveAssembly, worked_number_of_the_statement)
{
    EXPECT_TRUE(is_front_facing(std::vector<glm::vec2>{{1, 1}, {4, 1}, {2, 3}}));
    EXPECT_FALSE(is_front_facing(std::vector<glm::vec2>{{1, 1}, {2, 3}, {4, 1}}));
    EXPECT_FALSE(is_front_facing(std::vector<glm::vec2>{{1, 1}, {2, 2}, {4, 4}}));
    EXPECT_FALSE(is_front_facing({}));
}

// Against integers: coordinates are multiples of 1/256, areas sums of products of 23 bits.
TEST(PrimitiveAssembly, sides_of_slivers_are_exact)
{
    constexpr std::uint64_t seed = 20271;
    Random random(seed);
    for (int i = 0; i < 100'000; ++i) {
        const glm::i64vec2 u(1 + random.below(4'000'000), 1 + random.below(4'000'000));
        const glm::i64vec2 v = u + glm::i64vec2(static_cast<std::int64_t>(random.below(3)) - 1,
                                                static_cast<std::int64_t>(random.below(3)) - 1);
        const glm::i64vec2 a(static_cast<std::int64_t>(random.below(1000)) - 500, random.below(1000));
        const std::int64_t exact = u.x * v.y - u.y * v.x;
        const std::vector<glm::vec2> corners = {glm::vec2(a) / 256.0F, glm::vec2(a + u) / 256.0F,
                                                glm::vec2(a + v) / 256.0F};
        ASSERT_EQ(is_front_facing(corners), exact > 0) << "seed " << seed << ", row " << i;
    }
}

// V - E + F of what the modes give for an octagon: 8 points, 8 segments, 6 triangles of the polygon's whole area.
TEST(PrimitiveAssembly, modes_of_an_octagon)
{
    const std::vector<glm::vec2> places = on_circle(8);
    const auto list = [&](PolygonMode mode, Culling culling) {
        return draw_list(polygon, counted(8), places, culling, mode);
    };
    EXPECT_EQ(list(PolygonMode::point, Culling::back).points.size(), 8U);
    EXPECT_EQ(list(PolygonMode::line, Culling::back).segments.size(), 8U);
    double area = 0;
    for (const glm::uvec3& t : list(PolygonMode::fill, Culling::back).triangles) {
        const glm::vec2 a = places[t.y] - places[t.x];
        const glm::vec2 b = places[t.z] - places[t.x];
        area += 0.5 * static_cast<double>(a.x * b.y - a.y * b.x);
    }
    EXPECT_NEAR(area, 4 * 1e4 * std::sin(6.283185307179586 / 8), 0.1);
    EXPECT_TRUE(list(PolygonMode::fill, Culling::front).triangles.empty());
}

// Two strips joined by repeating a vertex twice: the triangles without area show nothing, in either mode, and keep the
// parity.
TEST(PrimitiveAssembly, joined_strips)
{
    std::vector<glm::vec2> places;
    for (int i = 0; i < 8; ++i) places.emplace_back(10 * (i / 2), 30 * (i / 4) + (i % 2 == 0 ? 10 : 0));
    const Indices joined = {0, 1, 2, 3, 3, 4, 4, 5, 6, 7};
    EXPECT_EQ(assemble(triangle_strip, joined).size(), 8U);
    EXPECT_EQ(draw_list(triangle_strip, joined, places, Culling::back, PolygonMode::fill).triangles,
              (std::vector<glm::uvec3>{{0, 1, 2}, {2, 1, 3}, {4, 5, 6}, {6, 5, 7}}));
}

// The statement's table: of 20,000 needles, the share for which a way in float takes the front for a back, or the other
// way round.
TEST(PrimitiveAssembly, table_of_the_statement)
{
    constexpr std::uint64_t seed = 77;
    struct Column {
        int reach;
        double products, subtracted;
    };
    for (const auto& [reach, products, subtracted] :
         {Column{30, 60, 0}, {200, 64, 34}, {1000, 68, 90}, {4000, 65, 99}, {16'000, 63, 100}}) {
        Random random(seed);
        glm::dvec2 wrong(0);
        for (int i = 0; i < 20'000; ++i) {
            std::array<glm::vec2, 3> corners = needle(random, 640, 480, reach, true);
            glm::bvec2 fails(false);
            for (int side = 0; side < 2; ++side) {
                const glm::vec2 u = corners[1] - corners[0];
                const glm::vec2 v = corners[2] - corners[0];
                float sum = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    const glm::vec2 a = corners[k];
                    const glm::vec2 b = corners[(k + 1) % 3];
                    sum += a.x * b.y - a.y * b.x;
                }
                const bool front = is_front_facing(corners);
                fails.x = fails.x || (sum > 0) != front;
                fails.y = fails.y || (u.x * v.y - u.y * v.x > 0) != front;
                std::swap(corners[0], corners[2]);
            }
            wrong += glm::dvec2(fails) / 200.0;
        }
        EXPECT_NEAR(wrong.x, products, 1.5) << "seed " << seed << ", reach " << reach;
        EXPECT_NEAR(wrong.y, subtracted, 1.5) << "seed " << seed << ", reach " << reach;
    }
}
