#pragma once

#include "../zoo.hpp"

/// Meshes made of the zoo's, for questions about counts.
namespace umbral::meshes {

/// The same mesh in another order, and of another size, which nothing depends on.
inline IndexedMesh another(IndexedMesh mesh, Random& random)
{
    const float size = random.uniform(0.5F, 2);
    for (glm::vec3& place : mesh.positions) place = size * (place + 0.01F);
    return shuffled(mesh, random);
}

/// Two or three meshes side by side, in an order that says nothing.
inline IndexedMesh mixture(const std::vector<Sample>& meshes, Random& random)
{
    IndexedMesh mesh;
    for (std::uint32_t parts = 2 + random.below(2); parts > 0; --parts)
        mesh = joined(mesh, meshes[random.below(static_cast<std::uint32_t>(meshes.size()))].mesh);
    return another(with_lonely_vertices(mesh, static_cast<int>(random.below(4))), random);
}

/// One triangle comes twice, the second time right behind the first, from the same corner or another one.
inline IndexedMesh with_one_twice(IndexedMesh mesh, Random& random)
{
    if (mesh.triangles.empty()) return mesh;
    const auto first = mesh.triangles.begin() + random.below(static_cast<std::uint32_t>(mesh.triangles.size()));
    const glm::uvec3 t = *first;
    mesh.triangles.insert(first + 1, random.below(2) == 0 ? t : glm::uvec3(t.y, t.z, t.x));
    return mesh;
}

/// A sheet with a row of holes, which do not touch each other: it has one rim more than holes.
inline IndexedMesh pierced_sheet(std::uint32_t holes)
{
    const std::uint32_t columns = 2 * holes + 1;
    const IndexedMesh whole = flat_sheet(columns, 3);
    IndexedMesh mesh{whole.positions, {}};
    for (std::uint32_t i = 0; i < whole.triangles.size(); ++i) {
        const std::uint32_t cell = i / 2;
        if (cell / columns != 1 || cell % columns % 2 == 0) mesh.triangles.push_back(whole.triangles[i]);
    }
    return mesh;
}

/// Surfaces of one piece with several rims each: as many as two, or more.
inline std::vector<Sample> with_several_rims()
{
    return {{"short tube", tube(5, 1)},
            {"sheet with a hole", pierced_sheet(1)},
            {"sheet with two holes", pierced_sheet(2)},
            {"sheet with three holes", pierced_sheet(3)},
            {"sheet with four holes", pierced_sheet(4)}};
}

/// Gives the mesh of fewer triangles a fan beside it that has the missing ones.
inline void pad_to_equal_size(IndexedMesh& a, IndexedMesh& b)
{
    IndexedMesh& fewer = a.triangles.size() < b.triangles.size() ? a : b;
    const auto missing =
        static_cast<std::uint32_t>(std::max(a.triangles.size(), b.triangles.size()) - fewer.triangles.size());
    IndexedMesh fan{{{0, 0, 0}, {1, 0, 0}}, {}};
    for (std::uint32_t i = 0; i < missing; ++i) {
        fan.positions.emplace_back(1, i + 1, 0);
        fan.triangles.emplace_back(0, i + 1, i + 2);
    }
    if (missing > 0) fewer = joined(fewer, fan);
}

/// Two meshes that share one vertex of each, wherever these lie: inside, or on a rim.
inline IndexedMesh glued(const IndexedMesh& first, const IndexedMesh& second, Random& random)
{
    IndexedMesh mesh = joined(first, second);
    const auto here = random.below(static_cast<std::uint32_t>(first.positions.size()));
    const auto there = static_cast<std::uint32_t>(first.positions.size()) +
                       random.below(static_cast<std::uint32_t>(second.positions.size()));
    for (glm::uvec3& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner)
            if (t[corner] == there) t[corner] = here;
    return mesh;
}

/// A closed surface, with a rim where a triangle was.
inline IndexedMesh opened(IndexedMesh mesh, Random& random)
{
    mesh.triangles.erase(mesh.triangles.begin() + random.below(static_cast<std::uint32_t>(mesh.triangles.size())));
    return mesh;
}

/// Two faces with the same three corners: a sphere, if they go round in opposite ways, else nothing.
inline IndexedMesh pillow(bool is_coherent)
{
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, is_coherent ? glm::uvec3(1, 0, 2) : glm::uvec3(1, 2, 0)}};
}

/// The numbers of the vertices begin at 0, at a million and at 2^20: two of them packed by either step, or cut at it,
/// are the same for other edges. The vertices between belong to no triangle.
inline IndexedMesh million(const IndexedMesh& mesh, Random& random)
{
    const IndexedMesh ordered = another(mesh, random);
    constexpr std::array<std::uint32_t, 3> firsts{0, 1'000'000, std::uint32_t{1} << 20U};
    IndexedMesh result{std::vector<glm::vec3>(firsts.back() + mesh.positions.size()), ordered.triangles};
    for (glm::uvec3& t : result.triangles)
        for (int corner = 0; corner < 3; ++corner) t[corner] = firsts[t[corner] % 3] + t[corner] / 3;
    return result;
}

}
