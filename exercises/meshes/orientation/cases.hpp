#pragma once

#include <kit/varied.hpp>
#include <map>
#include <utility>

#include "../zoo.hpp"

/// Meshes for questions of orientation.
namespace umbral::meshes {

/// Two cones that share their apex, and no edge: the course's example.
inline IndexedMesh hourglass(std::uint32_t sides)
{
    IndexedMesh mesh{{{0, 0, 0}, {0, -1, 0}, {0, 1, 0}}, {}};
    for (const std::uint32_t end : {1U, 2U}) {
        const float height = end == 1 ? -1.0F : 1.0F;
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (std::uint32_t i = 0; i < sides; ++i) {
            const double angle = 6.283185307179586 * i / sides;
            mesh.positions.emplace_back(0.9 * std::sin(angle), height, 0.9 * std::cos(angle));
            const std::uint32_t here = first + i;
            const std::uint32_t next = first + (i + 1) % sides;
            if (end == 1)
                mesh.triangles.insert(mesh.triangles.end(), {{0, here, next}, {1, next, here}});
            else
                mesh.triangles.insert(mesh.triangles.end(), {{0, next, here}, {2, here, next}});
        }
    }
    return mesh;
}

/// A staircase of cubes, each of which shares an edge with the next: a vertex can have several crowded edges.
inline IndexedMesh staircase(int steps)
{
    Cubes cubes;
    for (int i = 0; i < steps; ++i) cubes.insert({(i + 1) / 2, i % 2, i / 2});
    return centred(cube_surface(cubes, 1.6F / static_cast<float>(steps)));
}

/// Three sheets that share one line: a book with several triangles along its spine.
inline IndexedMesh three_sheets(std::uint32_t length)
{
    IndexedMesh mesh;
    for (std::uint32_t row = 0; row <= length; ++row)
        mesh.positions.emplace_back(0, 2.0F * static_cast<float>(row) / static_cast<float>(length) - 1, 0);
    for (int sheet = 0; sheet < 3; ++sheet) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const double angle = 2.0943951 * sheet;
        for (std::uint32_t row = 0; row <= length; ++row)
            mesh.positions.emplace_back(std::sin(angle), mesh.positions[row].y, std::cos(angle));
        for (std::uint32_t row = 0; row < length; ++row)
            add_quad(mesh, {row, first + row, first + row + 1, row + 1}, row % 2 == 0);
    }
    return mesh;
}

inline IndexedMesh turned_over(IndexedMesh mesh)
{
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    return mesh;
}

/// One of each fault, small enough to be drawn on paper, and one without.
inline std::vector<IndexedMesh> small_suspects()
{
    return {tetrahedron(),
            with_lonely_vertices(tetrahedron(), 1),
            bow_tie(),
            book(3),
            hourglass(3),
            three_sheets(1),
            cubes_at_a_corner(),
            cubes_at_an_edge(),
            turned_over(octahedron())};
}

/// The mesh, up to twice as large or as small.
inline IndexedMesh resized(const IndexedMesh& mesh, Random& random)
{
    const float factor = random.uniform(0.5F, 2);
    return mapped(mesh, [&](const glm::vec3& position) { return factor * position; });
}

/// Everything that is no manifold, or looks as if it were none, in random order.
inline std::vector<IndexedMesh> suspects(Variation& vary, Random& random)
{
    const std::uint32_t sides = 4 + random.below(8);
    const int steps = 3 + static_cast<int>(random.below(4));
    std::vector<IndexedMesh> meshes{hourglass(sides), staircase(steps), three_sheets(2 + random.below(4)),
                                    joined(hourglass(3), cubes_at_a_corner(), {3, 0, 0})};
    for (const Sample& sample : wild_meshes()) meshes.push_back(sample.mesh);
    for (const Sample& sample : tame_meshes(vary)) meshes.push_back(sample.mesh);
    for (IndexedMesh& mesh : meshes) mesh = with_mixed_winding(shuffled(resized(mesh, random), random), random);
    return in_random_order(random, std::move(meshes));
}

/// The mesh, and beside it one to three pieces that can be wound.
inline IndexedMesh with_other_pieces(IndexedMesh mesh, Random& random)
{
    const IndexedMesh pieces[] = {ball(5, 3), torus(5, 3), tube(5, 2), octahedron(), flat_sheet(3, 2)};
    const std::uint32_t count = 1 + random.below(3);
    for (std::uint32_t i = 1; i <= count; ++i)
        mesh = joined(mesh, pieces[random.below(5)], glm::vec3(0, 4 * static_cast<float>(i), 0));
    return mesh;
}

/// A body with a hole: all but one of its triangles, of which few lie at the edge.
inline IndexedMesh with_hole(IndexedMesh mesh)
{
    mesh.triangles.pop_back();
    return mesh;
}

/// A closed piece without any volume: a triangle and its back.
inline IndexedMesh flat_body() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}; }

/// Two cubes with one corner, each of which looks in or out.
inline IndexedMesh cubes_that_touch(Random& random)
{
    IndexedMesh mesh = cubes_at_a_corner();
    const std::size_t half = mesh.triangles.size() / 2;
    const bool turned[] = {random.below(2) == 0, random.below(2) == 0};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        if (turned[i < half ? 0 : 1]) std::swap(mesh.triangles[i].y, mesh.triangles[i].z);
    return mesh;
}

/// The body 2^exponent times as large.
inline IndexedMesh scaled_body(const IndexedMesh& body, int exponent)
{
    return mapped(body, [&](const glm::vec3& position) { return std::ldexp(1.0F, exponent) * position; });
}

/// Bodies one within the other, beside each other, and open sheets and bodies with a hole among them; about half of the
/// pieces look the wrong way. All are 2^exponent times as large.
inline IndexedMesh crowd(Random& random, int exponent)
{
    IndexedMesh mesh;
    const auto add = [&](const IndexedMesh& piece, const glm::vec3& place, float size) {
        const IndexedMesh scaled = mapped(piece, [&](const glm::vec3& position) { return size * position; });
        mesh = joined(mesh, random.below(2) == 0 ? turned_over(scaled) : scaled, place);
    };
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 place = 4.0F * glm::vec3(static_cast<float>(i), 0, 0);
        add(ball(9, 6), place, 1.5F);
        add(torus(7, 5), place, 0.7F);
        add(octahedron(), place, 0.2F);
        add(plate_with_holes(2), place + glm::vec3(0, 4, 0), 1);
        add(flat_sheet(3, 2), place - glm::vec3(0, 3, 0), 1);
        add(tube(5, 2), place - glm::vec3(0, 6, 0), 1);
        add(flat_body(), place + glm::vec3(0, 8, 0), 1);
        add(with_hole(i == 1 ? torus(7, 5) : ball(8, 5)), place - glm::vec3(0, 9, 0), 1);
        // At a crowded edge nobody has a neighbour, so these cubes are open; at a corner alone, two are two pieces.
        add(staircase(2 + i), place + glm::vec3(0, 12, 0), 1);
        add(cubes_that_touch(random), place + glm::vec3(0, 16, 0), 1);
    }
    return shuffled(scaled_body(mesh, exponent), random);
}

/// One small mesh at a time, in random order: closed, flat, or with a hole, looking out or in, of many sizes.
inline std::vector<IndexedMesh> single_bodies(Random& random)
{
    std::vector<IndexedMesh> meshes{IndexedMesh{}};
    for (const IndexedMesh& body : {tetrahedron(), octahedron(), cube(), flat_body(), with_hole(tetrahedron())})
        for (const int exponent : {-30, -3, 0, 0, 4, 30})
            for (const bool inwards : {false, true}) {
                const IndexedMesh scaled = scaled_body(inwards ? turned_over(body) : body, exponent);
                const IndexedMesh moved = joined({}, resized(scaled, random), scaled.positions[0]);
                meshes.push_back(shuffled(moved, random));
            }
    return in_random_order(random, std::move(meshes));
}

/// A body of 10 units across, this far from the origin, where its vertices have places of their own: multiples of
/// 2^step.
inline IndexedMesh far_body(const IndexedMesh& body, double distance, int step, Random& random)
{
    const glm::dvec3 away = distance * glm::dvec3(random.unit_vector());
    const double grid = std::ldexp(1.0, step);
    IndexedMesh mesh = mapped(body, [&](const glm::vec3& position) {
        return glm::vec3(grid * round((away + 5.0 * glm::dvec3(position)) / grid));
    });
    return random.below(2) == 0 ? turned_over(mesh) : mesh;
}

/// A slanted body that is a thousand times as wide as it is thick, about 10^7 units away along two axes: its volume
/// cancels even in double, unless it is seen from near by.
inline IndexedMesh thin_far_body(const IndexedMesh& body, Random& random)
{
    const auto far = [&] {
        return (random.below(2) == 0 ? 1.0F : -1.0F) * std::floor(random.uniform(0x1p23F, 0x1p24F));
    };
    const float away = far();
    const float aside = far();
    const int axis = static_cast<int>(random.below(3));
    const IndexedMesh mesh = mapped(body, [&](const glm::vec3& position) {
        const float across = std::round(8 * position.x);
        const glm::vec3 place(away + across, across + 0x1p-13F * position.y, aside + std::round(8 * position.z));
        return glm::vec3(place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3]);
    });
    return random.below(2) == 0 ? turned_over(mesh) : mesh;
}

/// Four bodies of 10 units across in one mesh, two of them near the origin and two 10^7 units away on different sides:
/// no point is near all of them. Seen from the corner of one of the others, volumes cancel even in double.
inline IndexedMesh bodies_far_apart(Random& random)
{
    const IndexedMesh kinds[] = {ball(8, 5), torus(7, 5), plate_with_holes(1), tetrahedron()};
    const std::uint32_t first = random.below(4);
    IndexedMesh mesh;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const IndexedMesh& kind = kinds[(first + i) % 4];
        const glm::vec3 middle = 20.0F * static_cast<float>(i) + random.in_cube();
        const IndexedMesh near = mapped(kind, [&](const glm::vec3& position) { return 5.0F * position + middle; });
        const bool is_turned = random.below(2) == 0;
        if (i < 2)
            mesh = joined(mesh, is_turned ? turned_over(near) : near);
        else
            mesh = joined(mesh, far_body(kind, 1e7, 0, random));
    }
    return shuffled(mesh, random);
}

/// The same mesh among 131,072 vertices, most of which no triangle has: its own have numbers from 0, 32,768, 65,536 and
/// 98,304 on. Two of them in 32 bits, as a * V + b or as a << 16 | b, are the same number for other edges.
inline IndexedMesh with_large_indices(const IndexedMesh& mesh, Random& random)
{
    constexpr std::uint32_t step = 32'768;
    IndexedMesh result = spread(mesh, step, random);
    result.positions.resize(4 * std::size_t{step}, glm::vec3(0));
    return result;
}

}
