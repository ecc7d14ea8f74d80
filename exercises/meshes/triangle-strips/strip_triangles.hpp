#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <iterator>
#include <tuple>
#include <umbral/meshes/mesh.hpp>
#include <umbral/meshes/strips.hpp>
#include <vector>

/// The triangles that strips draw, by the driver's own hand.
namespace umbral::meshes {

/// A triangle's corners in order, so that it is the same whichever way round it is written.
inline glm::uvec3 in_order(glm::uvec3 triangle)
{
    std::sort(&triangle.x, &triangle.x + 3);
    return triangle;
}

/// The triangles that strips draw, whatever strips they are; without those that nobody sees.
inline std::vector<glm::uvec3> triangles_in(const std::vector<Strip>& strips)
{
    std::vector<glm::uvec3> triangles;
    for (const Strip& strip : strips)
        for (std::size_t i = 2; i < strip.size(); ++i) {
            const glm::uvec3 triangle = in_order({strip[i - 2], strip[i - 1], strip[i]});
            if (triangle.x != triangle.y && triangle.y != triangle.z) triangles.push_back(triangle);
        }
    return triangles;
}

inline bool comes_before(const glm::uvec3& a, const glm::uvec3& b)
{
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

inline std::vector<glm::uvec3> sorted(std::vector<glm::uvec3> triangles)
{
    for (glm::uvec3& triangle : triangles) triangle = in_order(triangle);
    std::ranges::sort(triangles, comes_before);
    return triangles;
}

/// Do the strips draw these triangles, each as often as the mesh has it?
inline bool draw_all_of(const std::vector<Strip>& strips, const IndexedMesh& mesh)
{
    return sorted(triangles_in(strips)) == sorted(mesh.triangles);
}

/// Of a mesh of n triangles, how many of them the first n indices draw. A triangle that comes twice counts once.
inline std::size_t drawn_at_first(std::vector<Strip> strips, const IndexedMesh& mesh)
{
    std::size_t left = mesh.triangles.size();
    for (Strip& strip : strips) {
        strip.resize(std::min(strip.size(), left));
        left -= strip.size();
    }
    std::vector<glm::uvec3> right;
    std::ranges::set_intersection(sorted(triangles_in(strips)), sorted(mesh.triangles), std::back_inserter(right),
                                  comes_before);
    return right.size();
}

}
