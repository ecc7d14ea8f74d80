#include <nlohmann/json.hpp>

#include "scene/limits.hpp"
#include "scene/parts.hpp"
#include "scene/values.hpp"

namespace umbral::scene {
namespace {

int subdivisions(const Field& field, int least, int fallback)
{
    return field.given() ? field.integer(least, maximum_subdivisions) : fallback;
}

Shape parse_sphere(const Field& field)
{
    field.allow_only({"kind", "rings", "sectors"});
    const Sphere usual;
    return Sphere{subdivisions(field.member("rings"), 2, usual.rings),
                  subdivisions(field.member("sectors"), 3, usual.sectors)};
}

Shape parse_torus(const Field& field)
{
    field.allow_only({"kind", "rings", "sectors", "tube"});
    const Torus usual;
    return Torus{subdivisions(field.member("rings"), 3, usual.rings),
                 subdivisions(field.member("sectors"), 3, usual.sectors),
                 field.member("tube").given() ? real(field.member("tube"), 0.001, 0.999) : usual.tube};
}

Shape parse_plane(const Field& field)
{
    field.allow_only({"kind", "rows", "columns"});
    return Plane{subdivisions(field.member("rows"), 1, 1), subdivisions(field.member("columns"), 1, 1)};
}

Shape parse_wave(const Field& field)
{
    field.allow_only({"kind", "rows", "columns", "amplitude", "waves"});
    const Wave usual;
    return Wave{subdivisions(field.member("rows"), 1, usual.rows),
                subdivisions(field.member("columns"), 1, usual.columns), real(field.member("amplitude"), -10, 10),
                vector2(field.member("waves"), -100, 100)};
}

glm::uvec3 parse_triangle(const Field& field, std::size_t positions)
{
    const std::vector<Field> corners = field.items(3, 3);
    glm::uvec3 triangle;
    for (int i = 0; i < 3; ++i) {
        const Field& corner = corners[static_cast<std::size_t>(i)];
        if (positions == 0) corner.refuse("no index: there are no positions");
        triangle[i] = static_cast<unsigned>(corner.integer(0, static_cast<int>(positions) - 1));
    }
    return triangle;
}

Shape parse_triangles(const Field& field)
{
    field.allow_only({"kind", "positions", "triangles", "uvs"});
    Triangles mesh;
    for (const Field& position : field.member("positions").items(0, maximum_vertices))
        mesh.positions.push_back(vector3(position, -maximum_coordinate, maximum_coordinate));
    for (const Field& triangle : field.member("triangles").items(0, maximum_vertices))
        mesh.triangles.push_back(parse_triangle(triangle, mesh.positions.size()));
    if (const Field uvs = field.member("uvs"); uvs.given())
        for (const Field& uv : uvs.items(mesh.positions.size(), mesh.positions.size()))
            mesh.uvs.push_back(vector2(uv, -1000, 1000));
    return mesh;
}

Shape parse_box(const Field& field)
{
    field.allow_only({"kind"});
    return Box{};
}

/// Cylinder, Cone or Disc.
template <class Round>
Shape parse_round(const Field& field)
{
    field.allow_only({"kind", "sectors"});
    return Round{subdivisions(field.member("sectors"), 3, Round{}.sectors)};
}

Shape parse_revolution(const Field& field)
{
    field.allow_only({"kind", "profile", "sectors"});
    Revolution revolution;
    for (const Field& point : field.member("profile").items(2, maximum_profile)) {
        revolution.profile.push_back(vector2(point, -maximum_coordinate, maximum_coordinate));
        if (revolution.profile.back().x < 0) point.refuse("a distance from the axis of 0 or more, and a height");
    }
    revolution.sectors = subdivisions(field.member("sectors"), 3, revolution.sectors);
    return revolution;
}

Shape parse_teapot(const Field& field)
{
    field.allow_only({"kind", "subdivisions"});
    return Teapot{subdivisions(field.member("subdivisions"), 2, Teapot{}.subdivisions)};
}

Shape parse_distance_field(const Field& field)
{
    field.allow_only({"kind", "field", "cells"});
    DistanceField surface;
    surface.field = static_cast<FieldKind>(field.member("field").one_of({"mandelbulb"}));
    if (const Field cells = field.member("cells"); cells.given())
        surface.cells = cells.integer(minimum_cells, maximum_cells);
    return surface;
}

/// As Debian's packages are called. Messages put the name into a command that people copy.
bool is_package_name(const std::string& name)
{
    return name.size() > 1 && name.front() != '+' && name.front() != '-' && name.front() != '.' &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789+-.") == std::string::npos;
}

Shape parse_mesh_file(const Field& field)
{
    field.allow_only({"kind", "file", "package", "fit"});
    MeshFile mesh;
    mesh.file = field.member("file").text(maximum_path_length);
    if (mesh.file.size() < 5 || (!mesh.file.ends_with(".obj") && !mesh.file.ends_with(".ply")))
        field.member("file").refuse("a file's name that ends in .obj or .ply");
    if (const Field package = field.member("package"); package.given()) {
        mesh.package = package.text(maximum_name_length);
        if (!is_package_name(mesh.package))
            package.refuse("a Debian package's name: two or more of a-z, 0-9, +, - and ., the first a letter or digit");
    }
    if (const Field fit = field.member("fit"); fit.given()) mesh.fit = fit.boolean();
    return mesh;
}

}

Shape parse_shape(const Field& field)
{
    constexpr Shape (*parsers[])(const Field&) = {
        parse_sphere, parse_torus,           parse_plane,       parse_wave,        parse_triangles,
        parse_box,    parse_round<Cylinder>, parse_round<Cone>, parse_round<Disc>, parse_revolution,
        parse_teapot, parse_distance_field,  parse_mesh_file};
    static_assert(std::size(parsers) == std::variant_size_v<Shape>);
    return parsers[field.member("kind").one_of({"sphere", "torus", "plane", "wave", "triangles", "box", "cylinder",
                                                "cone", "disc", "revolution", "teapot", "distance-field", "mesh"})](
        field);
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
        std::size_t operator()(const Box&) const { return 12; }
        std::size_t operator()(const Cylinder& cylinder) const { return of(2, cylinder.sectors); }
        std::size_t operator()(const Cone& cone) const { return of(1, cone.sectors); }
        std::size_t operator()(const Disc& disc) const { return of(1, disc.sectors); }
        std::size_t operator()(const Revolution& one) const
        {
            return of(static_cast<int>(one.profile.size()) - 1, one.sectors);
        }
        std::size_t operator()(const Teapot& teapot) const { return 32 * of(teapot.subdivisions, teapot.subdivisions); }
        std::size_t operator()(const DistanceField& one) const
        {
            return field_triangles_per_cell * of(one.cells, one.cells);
        }
        std::size_t operator()(const MeshFile&) const { return 0; }
    };
    return std::visit(Count{sheet}, shape);
}

}
