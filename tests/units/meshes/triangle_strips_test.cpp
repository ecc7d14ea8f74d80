#include <gtest/gtest.h>

#include <meshes/triangle-strips/strip_log.hpp>
#include <meshes/zoo.hpp>
#include <umbral/meshes/strips.hpp>

using namespace umbral;
using namespace umbral::meshes;

namespace {

std::vector<glm::uvec3> canonical(std::vector<glm::uvec3> triangles)
{
    std::erase_if(triangles, [](const glm::uvec3& t) { return t.x == t.y || t.y == t.z || t.z == t.x; });
    std::ranges::transform(triangles, triangles.begin(), turned);
    std::ranges::sort(triangles, [](const glm::uvec3& a, const glm::uvec3& b) {
        return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
    });
    return triangles;
}

std::vector<glm::uvec3> in_order(std::vector<glm::uvec3> triangles)
{
    std::ranges::transform(triangles, triangles.begin(), turned);
    return triangles;
}

std::size_t index_count(const std::vector<Strip>& strips)
{
    std::size_t count = 0;
    for (const Strip& strip : strips) count += strip.size();
    return count;
}

}

// Problem 2.3: 24 n m + 32 m + 4 bytes for a grid of n x m cells.
TEST(TriangleStrips, strips_of_coordinates_take_the_courses_bytes)
{
    for (const auto& [columns, rows] : {std::pair{8U, 4U}, {128U, 128U}, {1U, 1U}}) {
        const std::vector<Strip> strips = grid_strips(columns, rows);
        const StripBytes bytes = strip_bytes((columns + 1) * (rows + 1), strips);
        EXPECT_EQ(bytes.coordinates, 24 * columns * rows + 32 * rows + 4);
        EXPECT_EQ(bytes.indexed, 4 + 8 * rows + 12 * (columns + 1) * (rows + 1) + 4 * rows * (2 * columns + 2));
    }
    const std::vector<glm::vec3> positions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    const std::vector<std::vector<glm::vec3>> expected = {{{7, 8, 9}, {1, 2, 3}, {7, 8, 9}}, {}};
    EXPECT_EQ(strips_of_coordinates(positions, {{2, 0, 2}, {}}), expected);
}

TEST(TriangleStrips, parity_restart_and_repeats)
{
    using Triangles = std::vector<glm::uvec3>;
    EXPECT_EQ(in_order(triangles_of_strip({0, 1, 2, 3, 4})), (Triangles{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
    EXPECT_EQ(in_order(triangles_of_strip({0, 1, 2, restart_index, 3, 4, 5, 6})),
              (Triangles{{0, 1, 2}, {3, 4, 5}, {4, 6, 5}}));
    EXPECT_EQ(in_order(triangles_of_strip({0, 1, 2, 2, 3, 4})), (Triangles{{0, 1, 2}, {2, 4, 3}}))
        << "what is not drawn counts";
    EXPECT_TRUE(triangles_of_strip({}).empty());
    EXPECT_TRUE(triangles_of_strip({0, 1, restart_index, 2, 3}).empty());
}

// The strips of a grid have all its triangles, counter-clockwise, and as many indices as problem 2.3 says.
TEST(TriangleStrips, grid)
{
    for (const auto& [columns, rows] : {std::pair{1U, 1U}, {8U, 4U}, {3U, 7U}}) {
        const std::vector<Strip> strips = grid_strips(columns, rows);
        EXPECT_EQ(strips.size(), rows);
        EXPECT_EQ(index_count(strips), std::size_t{rows} * (2 * columns + 2));
        std::size_t triangles = 0;
        for (const Strip& strip : strips) {
            for (const glm::uvec3& t : triangles_of_strip(strip)) {
                const auto place = [&](std::uint32_t vertex) {
                    return glm::ivec2(vertex % (columns + 1), vertex / (columns + 1));
                };
                const glm::ivec2 u = place(t.y) - place(t.x);
                const glm::ivec2 v = place(t.z) - place(t.x);
                EXPECT_EQ(u.x * v.y - u.y * v.x, 1);
                ++triangles;
            }
        }
        EXPECT_EQ(triangles, 2 * std::size_t{columns} * rows);
    }
    EXPECT_TRUE(grid_strips(0, 5).empty());
    EXPECT_TRUE(grid_strips(5, 0).empty());
}

TEST(TriangleStrips, joined_strips_draw_the_same)
{
    constexpr std::uint64_t seed = 20301;
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        std::vector<Strip> strips(random.below(6));
        std::vector<glm::uvec3> expected;
        for (Strip& strip : strips) {
            for (std::uint32_t k = random.below(8); k > 0; --k) strip.push_back(random.below(12));
            const std::vector<glm::uvec3> triangles = triangles_of_strip(strip);
            expected.insert(expected.end(), triangles.begin(), triangles.end());
        }
        ASSERT_EQ(triangles_of_strip(join_strips(strips)), expected) << "seed " << seed << ", round " << i;
    }
}

TEST(TriangleStrips, every_triangle_once_as_it_is_wound)
{
    constexpr std::uint64_t seed = 20302;
    Random random(seed);
    for (const auto& meshes : {tame_meshes(), wild_meshes()}) {
        for (const Sample& sample : meshes) {
            for (const IndexedMesh& mesh : {shuffled(sample.mesh, random), with_mixed_winding(sample.mesh, random)}) {
                const std::vector<Strip> strips = make_strips(mesh);
                EXPECT_EQ(drawn(strips, mesh.triangles.size()), canonical(mesh.triangles))
                    << sample.name << ", seed " << seed;
                std::vector<glm::uvec3> decoded;
                for (const Strip& strip : strips)
                    for (const glm::uvec3& t : triangles_of_strip(strip)) decoded.push_back(t);
                EXPECT_EQ(canonical(decoded), canonical(mesh.triangles)) << sample.name;
            }
        }
    }
}

// A tube that closes is one strip, if its triangles allow it; in any order most triangles of a grid join strips.
TEST(TriangleStrips, strips_are_long)
{
    Random random(20303);
    for (const IndexedMesh& mesh : {torus(20, 12), trefoil(40, 7, 0.4), ball(20, 20)})
        EXPECT_LT(index_count(make_strips(shuffled(mesh, random))), 3 * mesh.triangles.size() / 2);
}
