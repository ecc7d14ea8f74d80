#include <nlohmann/json.hpp>

#include "scene/limits.hpp"
#include "scene/parts.hpp"

namespace umbral::scene {
namespace {

int subdivisions(const Node& node, int least, int fallback) { return node.given() ? node.integer(least, maximum_subdivisions) : fallback; }

Shape parse_sphere(const Node& node)
{
    node.allow_only({"kind", "rings", "sectors"});
    const Sphere usual;
    return Sphere{subdivisions(node.member("rings"), 2, usual.rings), subdivisions(node.member("sectors"), 3, usual.sectors)};
}

Shape parse_torus(const Node& node)
{
    node.allow_only({"kind", "rings", "sectors", "tube"});
    const Torus usual;
    return Torus{subdivisions(node.member("rings"), 3, usual.rings), subdivisions(node.member("sectors"), 3, usual.sectors),
                 node.member("tube").given() ? node.member("tube").number(0.001, 0.999) : usual.tube};
}

Shape parse_plane(const Node& node)
{
    node.allow_only({"kind", "rows", "columns"});
    return Plane{subdivisions(node.member("rows"), 1, 1), subdivisions(node.member("columns"), 1, 1)};
}

Shape parse_wave(const Node& node)
{
    node.allow_only({"kind", "rows", "columns", "amplitude", "waves"});
    const Wave usual;
    return Wave{subdivisions(node.member("rows"), 1, usual.rows), subdivisions(node.member("columns"), 1, usual.columns),
                node.member("amplitude").number(-10, 10), node.member("waves").vector2(-100, 100)};
}

glm::uvec3 parse_triangle(const Node& node, std::size_t positions)
{
    const std::vector<Node> corners = node.items(3, 3);
    glm::uvec3 triangle;
    for (int i = 0; i < 3; ++i) {
        const Node& corner = corners[static_cast<std::size_t>(i)];
        if (positions == 0) corner.refuse("no index: there are no positions");
        triangle[i] = static_cast<unsigned>(corner.integer(0, static_cast<int>(positions) - 1));
    }
    return triangle;
}

Shape parse_triangles(const Node& node)
{
    node.allow_only({"kind", "positions", "triangles", "uvs"});
    Triangles mesh;
    for (const Node& position : node.member("positions").items(0, maximum_vertices))
        mesh.positions.push_back(position.vector3(-maximum_coordinate, maximum_coordinate));
    for (const Node& triangle : node.member("triangles").items(0, maximum_vertices)) mesh.triangles.push_back(parse_triangle(triangle, mesh.positions.size()));
    if (const Node uvs = node.member("uvs"); uvs.given())
        for (const Node& uv : uvs.items(mesh.positions.size(), mesh.positions.size())) mesh.uvs.push_back(uv.vector2(-1000, 1000));
    return mesh;
}

}

Shape parse_shape(const Node& node)
{
    constexpr Shape (*parsers[])(const Node&) = {parse_sphere, parse_torus, parse_plane, parse_wave, parse_triangles};
    return parsers[node.member("kind").one_of({"sphere", "torus", "plane", "wave", "triangles"})](node);
}

std::size_t triangle_count(const Shape& shape)
{
    const auto sheet = [](int a, int b) { return 2 * static_cast<std::size_t>(a) * static_cast<std::size_t>(b); };
    struct Count {
        decltype(sheet) of;
        std::size_t operator()(const Sphere& sphere) const { return of(sphere.rings, sphere.sectors); }
        std::size_t operator()(const Torus& torus) const { return of(torus.rings, torus.sectors); }
        std::size_t operator()(const Plane& plane) const { return of(plane.rows, plane.columns); }
        std::size_t operator()(const Wave& wave) const { return of(wave.rows, wave.columns); }
        std::size_t operator()(const Triangles& mesh) const { return mesh.triangles.size(); }
    };
    return std::visit(Count{sheet}, shape);
}

}
