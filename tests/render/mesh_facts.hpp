#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <umbral/meshes/mesh.hpp>
#include <utility>
#include <vector>

namespace umbral::render::test {

/// What a mesh is as a surface, by its indices alone.
struct MeshFacts {
    int parts = 0;                      ///< that hang together
    int borders = 0;                    ///< closed lines of edges with one triangle
    int euler = 0;                      ///< vertices that are used - edges + triangles
    bool is_oriented = true;            ///< triangles run along a common edge in opposite senses
    int most_triangles_at_an_edge = 0;  ///< 2 for a surface
};

/// Which things hang together, each named by one of them.
class Union {
public:
    explicit Union(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0U); }
    unsigned of(unsigned one)
    {
        while (parents_[one] != one) one = parents_[one] = parents_[parents_[one]];
        return one;
    }
    void join(unsigned one, unsigned other) { parents_[of(one)] = of(other); }

private:
    std::vector<unsigned> parents_;
};

[[nodiscard]] inline MeshFacts facts_of(const meshes::IndexedMesh& mesh)
{
    struct Uses {
        int up = 0;
        int down = 0;
    };
    std::map<std::pair<unsigned, unsigned>, Uses> edges;
    Union parts(mesh.positions.size());
    std::set<unsigned> used;
    for (const glm::uvec3& triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            const unsigned a = triangle[i];
            const unsigned b = triangle[(i + 1) % 3];
            Uses& uses = edges[std::minmax(a, b)];
            ++(a < b ? uses.up : uses.down);
            parts.join(a, b);
            used.insert(a);
        }
    MeshFacts facts;
    Union borders(mesh.positions.size());
    std::set<unsigned> on_border;
    for (const auto& [edge, uses] : edges) {
        facts.most_triangles_at_an_edge = std::max(facts.most_triangles_at_an_edge, uses.up + uses.down);
        if (uses.up > 1 || uses.down > 1) facts.is_oriented = false;
        if (uses.up + uses.down > 1) continue;
        borders.join(edge.first, edge.second);
        on_border.insert({edge.first, edge.second});
    }
    std::set<unsigned> names;
    for (const unsigned one : used) names.insert(parts.of(one));
    facts.parts = static_cast<int>(names.size());
    names.clear();
    for (const unsigned one : on_border) names.insert(borders.of(one));
    facts.borders = static_cast<int>(names.size());
    facts.euler =
        static_cast<int>(used.size()) - static_cast<int>(edges.size()) + static_cast<int>(mesh.triangles.size());
    return facts;
}

}
