#include <gtest/gtest.h>

#include <meshes/weld/soups.hpp>
#include <umbral/meshes/weld.hpp>

using namespace umbral;
using namespace umbral::meshes;

namespace {

/// Compares each corner with all vertices before it: the definition.
IndexedMesh welded_by_definition(const Soup& soup)
{
    IndexedMesh mesh;
    std::vector<std::uint32_t> indices;
    for (const glm::vec3& corner : soup) {
        const auto found = std::find(mesh.positions.begin(), mesh.positions.end(), corner);
        indices.push_back(static_cast<std::uint32_t>(found - mesh.positions.begin()));
        if (found == mesh.positions.end()) mesh.positions.push_back(corner);
    }
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        mesh.triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
    return mesh;
}

bool same_place(const glm::vec3& a, const glm::vec3& b)
{
    for (int i = 0; i < 3; ++i)
        if (a[i] != b[i] && !(std::isnan(a[i]) && std::isnan(b[i]))) return false;
    return true;
}

void expect_same(const IndexedMesh& got, const IndexedMesh& expected, const std::string& what)
{
    EXPECT_EQ(got.triangles, expected.triangles) << what;
    EXPECT_TRUE(std::ranges::equal(got.positions, expected.positions, same_place)) << what;
}

}

TEST(Weld, agrees_with_the_definition)
{
    constexpr std::uint64_t seed = 21001;
    Random random(seed);
    for (int i = 0; i < 5; ++i) {
        const std::string what = "seed " + std::to_string(seed) + ", round " + std::to_string(i);
        for (const Soup& soup : {soup_of_two_zeros(random), soup_of_close_places(random),
                                 soup_of_broken_corners(random), soup_of_few_places(random), aligned_soup(20, random)})
            expect_same(weld(soup), welded_by_definition(soup), what);
    }
}

TEST(Weld, way_back_gives_the_corners_again)
{
    Random random(21002);
    for (const Sample& sample : tame_meshes()) {
        const Soup soup = soup_of(shuffled(sample.mesh, random));
        const IndexedMesh mesh = weld(soup);
        EXPECT_EQ(mesh.positions.size(), sample.mesh.positions.size()) << sample.name;
        EXPECT_EQ(isolated_triangles(mesh), soup) << sample.name;
    }
}

TEST(Weld, nothing_gives_nothing)
{
    EXPECT_TRUE(weld({}).positions.empty());
    EXPECT_TRUE(isolated_triangles({{{1, 2, 3}}, {}}).empty());
}
