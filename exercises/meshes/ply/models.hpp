#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <umbral/meshes/ply.hpp>

#include "../football.hpp"
#include "../show.hpp"
#include "../support.hpp"

/// The three models of the picture: polygons of several kinds.
namespace umbral::meshes {

/// A ring of quadrilaterals with a square section that turns once on its way round.
inline PolygonMesh twisted_ring(std::uint32_t columns = 36)
{
    PolygonMesh mesh;
    const auto at = [&](std::uint32_t column, std::uint32_t row) {
        return column < columns ? 4 * column + row % 4 : (row + 1) % 4;
    };
    for (std::uint32_t column = 0; column < columns; ++column) {
        for (std::uint32_t row = 0; row < 4; ++row) {
            const double u = 6.283185307179586 * column / columns;
            const double v = 6.283185307179586 * (row + 0.5) / 4 + u / 4;
            const double out = 0.85 + 0.42 * std::cos(v);
            mesh.positions.emplace_back(out * std::sin(u), 0.42 * std::sin(v), out * std::cos(u));
            mesh.faces.push_back({at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)});
        }
    }
    return mesh;
}

/// The trefoil knot of the vertex normals, in triangles.
inline PolygonMesh knot(std::uint32_t along = 72)
{
    const IndexedMesh tube = mapped(trefoil(along, 8, 0.5), [](const glm::vec3& position) { return 0.35F * position; });
    PolygonMesh mesh{tube.positions, {}};
    for (const glm::uvec3& t : tube.triangles) mesh.faces.push_back({t.x, t.y, t.z});
    return mesh;
}

/// 640 x 240 pixels: the models side by side, a colour for each number of corners, and the edges of the faces.
inline Image picture_of(std::span<const PolygonMesh> models)
{
    Show show(3, 1, 220, 220);
    for (int column = 0; column < static_cast<int>(models.size()); ++column) {
        const PolygonMesh& model = models[static_cast<std::size_t>(column)];
        show.pane(column, 0, {{1.6F, 2.6F, 4.4F}, {0, 0, 0}, 27});
        const glm::vec3 of_corners[] = {ink::blue, ink::orange, {0.16F, 0.18F, 0.24F}, {0.93F, 0.93F, 0.90F}};
        std::vector<glm::vec3> colors;
        std::vector<std::array<glm::vec3, 2>> edges;
        for (const auto& face : model.faces) {
            for (std::size_t i = 2; i < face.size(); ++i)
                colors.push_back(of_corners[std::clamp<std::size_t>(face.size(), 3, 6) - 3]);
            for (std::size_t i = 0; i < face.size(); ++i) {
                const std::uint32_t a = face[i];
                const std::uint32_t b = face[(i + 1) % face.size()];
                if (a < b && b < model.positions.size()) edges.push_back({model.positions[a], model.positions[b]});
            }
        }
        show.mesh(fan_triangles(model), colors, {-1});  // no edges of triangles
        show.lines(edges, {0.05F, 0.06F, 0.08F}, 1.3F);
    }
    return show.picture();
}

}
