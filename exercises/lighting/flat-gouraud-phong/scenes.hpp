#pragma once

#include <umbral/core/random.hpp>
#include <umbral/lighting/shading_methods.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// Small scenes for the drivers and tests of shading methods.
namespace umbral::lighting {

struct StagedMesh {
    std::vector<StagedVertex> vertices;
    std::vector<glm::uvec3> triangles;
};

/// An empty target; `depth` is what everything in front of it covers.
inline pipeline::Layer empty_layer(int width, int height, float depth = 1)
{
    return {Grid<glm::vec3>(width, height, glm::vec3(0)), Grid<float>(width, height, depth)};
}

/// A place in the window, on quarters of pixels and up to 3 pixels outside, with any place and normal in the world; one
/// in six lies in the near or the far plane.
inline StagedVertex random_vertex(Random& random, int size)
{
    const auto on_grid = [&] {
        return static_cast<float>(random.below(static_cast<std::uint32_t>(4 * size + 24))) / 4 - 3;
    };
    const float x = on_grid();
    const float y = on_grid();
    const auto plane = static_cast<float>(random.below(2));
    const float depth = random.below(6) == 0 ? plane : random.uniform(0.05F, 0.95F);
    const float inverse_w = std::exp2(-2 * random.uniform());
    const glm::vec3 position = 4.0F * random.in_cube();
    return {{{x, y}, depth, inverse_w}, {position, random.unit_vector()}};
}

/// Triangles without order: they share vertices, lie over each other, and cut each other.
inline StagedMesh random_mesh(Random& random, int size, std::uint32_t vertices, int triangles)
{
    StagedMesh mesh;
    for (std::uint32_t i = 0; i < vertices; ++i) mesh.vertices.push_back(random_vertex(random, size));
    for (int i = 0; i < triangles; ++i) {
        const std::uint32_t a = random.below(vertices);
        const std::uint32_t b = (a + 1 + random.below(vertices - 2)) % vertices;
        const std::uint32_t c = random.below(vertices);
        mesh.triangles.push_back({a, b, c == a || c == b ? (b + 1) % vertices : c});
    }
    return mesh;
}

/// A square of the window, in two triangles that share a side, at that depth. In the world it lies in the plane z = 0;
/// its normals lean outwards by `lean`, as on a sphere, and are unit.
inline StagedMesh square(float low, float high, float depth, float lean, float inverse_w = 1)
{
    StagedMesh mesh;
    for (int i = 0; i < 4; ++i) {
        const glm::vec2 corner(i == 1 || i == 2 ? 1 : -1, i >= 2 ? 1 : -1);
        const glm::vec2 place = glm::mix(glm::vec2(low), glm::vec2(high), 0.5F + 0.5F * glm::vec2(corner.x, -corner.y));
        mesh.vertices.push_back(
            {{place, depth, i == 1 ? inverse_w : 1}, {{corner, 0}, normalize(glm::vec3(lean * corner, 1))}});
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

/// The mesh behind more vertices and triangles than 16 bits count, which lie outside of the window.
inline StagedMesh behind_many_others(const StagedMesh& mesh, std::uint32_t others)
{
    StagedMesh all;
    for (std::uint32_t i = 0; i < others; ++i) {
        const glm::vec2 place(i % 2 == 0 ? -9 : -5, i % 3 == 0 ? -9 : -5);
        all.vertices.push_back({{place, 0.5F, 1}, {glm::vec3(3, 4, 5), glm::vec3(0, 1, 0)}});
        all.triangles.push_back({0, 1, 3});
    }
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const glm::uvec3& triangle : mesh.triangles) all.triangles.push_back(triangle + others);
    return all;
}

/// The same in the window, and turned or mirrored exactly in the world, and larger or smaller there. As it is unless
/// inputs are to vary.
inline StagedMesh turned_in_world(Variation& vary, StagedMesh mesh)
{
    const ExactMap map = vary.exact_map();
    for (StagedVertex& vertex : mesh.vertices)
        vertex.at = {map.place(vertex.at.position), map.direction(vertex.at.normal)};
    return mesh;
}

}
