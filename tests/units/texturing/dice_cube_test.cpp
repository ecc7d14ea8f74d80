#include <gtest/gtest.h>

#include <array>
#include <set>
#include <texturing/dice-cube/observe.hpp>
#include <tuple>

// Linked with the reference. What is expected: the course's numbers of vertices, the net folded by hand at single
// places, and all ways to turn the replicated image, tried.

using namespace umbral;
using namespace umbral::texturing;

namespace {

enum { front, right, top, bottom, left, back };

glm::vec2 at(const TexturedCube& cube, int side, glm::vec2 place)
{
    return seen(triangles_of(cube), sides[static_cast<std::size_t>(side)], place).coordinates;
}

void expect_near(glm::vec2 actual, glm::vec2 expected)
{
    EXPECT_NEAR(actual.x, expected.x, 1e-6F);
    EXPECT_NEAR(actual.y, expected.y, 1e-6F);
}

void expect_covered_once(const TexturedCube& cube)
{
    constexpr std::uint64_t seed = 20311;
    Random random(seed);
    const std::vector<Triangle> triangles = triangles_of(cube);
    ASSERT_EQ(triangles.size(), 12U);
    for (const Side& side : sides)
        for (int i = 0; i < 200; ++i) {
            const float x = random.uniform(0.01F, 0.99F);
            const Seen here = seen(triangles, side, {x, random.uniform(0.01F, 0.99F) * 0.999F});
            EXPECT_EQ(here.covers, glm::vec2(1, 0)) << "seed " << seed;
        }
}

}

TEST(DiceCube, vertices_are_as_few_as_the_course_says)
{
    EXPECT_EQ(dice_cube().positions.size(), 14U);
    EXPECT_EQ(lit_dice_cube().positions.size(), 24U);
    EXPECT_EQ(replicated_cube().positions.size(), 14U);
    for (const TexturedCube& cube : {dice_cube(), lit_dice_cube(), replicated_cube()})
        EXPECT_EQ(cube.coordinates.size(), cube.positions.size());
    EXPECT_TRUE(dice_cube().normals.empty());
    EXPECT_EQ(lit_dice_cube().normals.size(), 24U);
}

TEST(DiceCube, faces_are_covered_once_from_outside)
{
    expect_covered_once(dice_cube());
    expect_covered_once(lit_dice_cube());
    expect_covered_once(replicated_cube());
}

// Folded by hand: a place of each face, off its middle in both directions.
TEST(DiceCube, the_net_is_folded_as_the_interface_draws_it)
{
    for (const TexturedCube& cube : {dice_cube(), lit_dice_cube()}) {
        expect_near(at(cube, front, {0.2F, 0.4F}), {2.2F / 4, 1.4F / 3});
        expect_near(at(cube, right, {0.2F, 0.4F}), {3.2F / 4, 1.4F / 3});
        expect_near(at(cube, top, {0.2F, 0.4F}), {2.2F / 4, 2.4F / 3});
        expect_near(at(cube, bottom, {0.2F, 0.4F}), {2.2F / 4, 0.4F / 3});
        expect_near(at(cube, left, {0.2F, 0.4F}), {1.2F / 4, 1.4F / 3});
        expect_near(at(cube, back, {0.2F, 0.4F}), {0.2F / 4, 1.4F / 3});
    }
}

// Paper does not tear: along an edge where two cells of the net touch, the two faces have the same coordinates.
TEST(DiceCube, faces_that_touch_in_the_net_agree_along_the_fold)
{
    const TexturedCube cube = dice_cube();
    for (const float t : {0.1F, 0.45F, 0.8F}) {
        expect_near(at(cube, front, {1, t}), at(cube, right, {0, t}));
        expect_near(at(cube, front, {t, 1}), at(cube, top, {t, 0}));
        expect_near(at(cube, front, {t, 0}), at(cube, bottom, {t, 1}));
        expect_near(at(cube, left, {1, t}), at(cube, front, {0, t}));
        expect_near(at(cube, back, {1, t}), at(cube, left, {0, t}));
    }
}

TEST(DiceCube, normals_are_those_of_the_faces)
{
    for (const Triangle& triangle : triangles_of(lit_dice_cube())) {
        const glm::vec3 normal =
            normalize(cross(triangle[1].position - triangle[0].position, triangle[2].position - triangle[0].position));
        for (const Corner& corner : triangle) EXPECT_EQ(corner.normal, normal);
    }
}

TEST(DiceCube, replicated_images_are_whole_and_not_mirrored)
{
    const std::vector<Triangle> triangles = triangles_of(replicated_cube());
    constexpr glm::vec2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const Side& side : sides) {
        const std::array<glm::vec2, 4> corners = corners_of(triangles, side);
        for (std::size_t k = 0; k < 4; ++k) EXPECT_LT(distance(corners[k], square[k]), 2e-3F);
    }
}

// All 4^6 ways to turn six images that are not mirrored: at least 14 vertices, in 128 ways.
TEST(DiceCube, no_way_to_turn_the_images_needs_fewer_vertices)
{
    constexpr int square[][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    using Vertex = std::tuple<int, int, int, int, int>;
    std::size_t fewest = 24;
    int ways = 0;
    for (unsigned turns = 0; turns < 4096; ++turns) {
        std::set<Vertex> vertices;
        for (std::size_t side = 0; side < 6; ++side)
            for (unsigned k = 0; k < 4; ++k) {
                const glm::ivec3 p(sides[side].at({square[k][0], square[k][1]}));
                const int* uv = square[(k + (turns >> (2 * side))) % 4];
                vertices.emplace(p.x, p.y, p.z, uv[0], uv[1]);
            }
        if (vertices.size() < fewest) ways = 0;
        fewest = std::min(fewest, vertices.size());
        ways += vertices.size() == fewest ? 1 : 0;
    }
    EXPECT_EQ(fewest, 14U);
    EXPECT_EQ(ways, 128);
}
