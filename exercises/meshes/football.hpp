#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <umbral/meshes/polygons.hpp>
#include <utility>
#include <vector>

namespace umbral::meshes {

/// A football: an icosahedron with its twelve corners cut off. 12 pentagons and 20 hexagons.
inline PolygonMesh football()
{
    const double golden = (1 + std::sqrt(5.0)) / 2;
    std::vector<glm::dvec3> corners;
    for (const double one : {1.0, -1.0})
        for (const double other : {golden, -golden})
            corners.insert(corners.end(), {{0, one, other}, {one, other, 0}, {other, 0, one}});
    std::map<std::pair<int, int>, std::uint32_t> places;  // on the edge (from, to), a third of the way
    PolygonMesh mesh;
    const auto is_edge = [&](int a, int b) {
        return a != b && distance(corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)]) < 2.1;
    };
    const auto at = [&](int from, int to) {
        const auto [found, is_new] = places.try_emplace({from, to}, static_cast<std::uint32_t>(mesh.positions.size()));
        const glm::dvec3 place =
            (2.0 * corners[static_cast<std::size_t>(from)] + corners[static_cast<std::size_t>(to)]) / 3.0;
        if (is_new) mesh.positions.emplace_back(0.64 * place);
        return found->second;
    };
    for (int a = 0; a < 12; ++a) {
        // The neighbours of a corner, counter-clockwise: each is a neighbour of the next.
        const auto turns_left = [&](int b, int c) {
            return is_edge(b, c) &&
                   dot(corners[static_cast<std::size_t>(a)],
                       cross(corners[static_cast<std::size_t>(b)], corners[static_cast<std::size_t>(c)])) > 0;
        };
        std::vector<int> ring;
        for (int b = 0; ring.empty(); ++b)
            if (is_edge(a, b)) ring.push_back(b);
        while (ring.size() < 5)
            for (int c = 0; c < 12; ++c)
                if (is_edge(a, c) && turns_left(ring.back(), c)) {
                    ring.push_back(c);
                    break;
                }
        std::vector<std::uint32_t> pentagon;
        for (const int b : ring) pentagon.push_back(at(a, b));
        mesh.faces.push_back(pentagon);
        for (std::size_t i = 0; i < 5; ++i) {
            const int b = ring[i];
            const int c = ring[(i + 1) % 5];
            if (a < b && a < c) mesh.faces.push_back({at(a, b), at(b, a), at(b, c), at(c, b), at(c, a), at(a, c)});
        }
    }
    return mesh;
}

}
