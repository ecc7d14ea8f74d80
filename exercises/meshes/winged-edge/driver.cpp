#include <kit/amount.hpp>
#include <kit/varied.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>

#include "../show.hpp"
#include "tables.hpp"

namespace umbral {
namespace {

using namespace meshes;

/// Numbers as a row of floats; indices are small enough, and what is not there is not a number.
void append_row(Recorder& out, const char* name, std::initializer_list<std::uint32_t> numbers)
{
    std::vector<float> row;
    for (const std::uint32_t number : numbers) row.push_back(static_cast<float>(number));
    out.append(name, std::span<const float>(row));
}

/// Not a number where the list is too short.
float entry(const std::vector<std::uint32_t>& list, std::size_t i)
{
    return i < list.size() ? static_cast<float>(list[i]) : std::nanf("");
}

void append_list(Recorder& out, const char* name, const std::vector<std::uint32_t>& list, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i) out.append(name, entry(list, i));
}

/// Which table the rows of "starts" are of.
enum class Of { vertex, face };

void append_starts(Recorder& out, Of of, const std::vector<std::uint32_t>& edges, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i)
        out.append("starts", std::vector<float>{static_cast<float>(of), static_cast<float>(i), entry(edges, i)});
}

/// The three tables; `expected` says how long they should be.
void record_tables(Recorder& out, const PolygonMesh& mesh)
{
    std::size_t corners = 0;
    for (const auto& face : mesh.faces) corners += face.size();
    const auto result = ask<winged_edges>(out, mesh);
    const auto* const got = std::get_if<WingedMesh>(&result);
    const WingedMesh tables = got != nullptr ? *got : WingedMesh{};
    out.columns("edges", "start, end, left, right, left_previous, left_next, right_previous, right_next");
    out.append("edges", std::vector<float>{static_cast<float>(tables.edges.size()), 0, 0, 0, 0, 0, 0, 0});
    for (std::size_t i = 0; i < corners / 2; ++i) {
        if (i < tables.edges.size()) {
            const WingedEdge& e = tables.edges[i];
            append_row(out, "edges",
                       {e.start, e.end, e.left, e.right, e.left_previous, e.left_next, e.right_previous, e.right_next});
        } else {
            out.append("edges", std::vector<float>(8, std::nanf("")));
        }
    }
    out.columns("starts", "table (0: edge_of_vertex; 1: edge_of_face), number, edge");
    append_starts(out, Of::vertex, tables.edge_of_vertex, mesh.positions.size());
    append_starts(out, Of::face, tables.edge_of_face, mesh.faces.size());
}

/// The fault and where; zeros for a mesh that was accepted.
void record_fault(Recorder& out, const PolygonMesh& mesh)
{
    out.columns("faults",
                "fault (0: none; 1: face; 2: crowded_edge; 3: open_edge; 4: incoherent_edge; 5: lonely_vertex; 6: "
                "pinched_vertex), a, b");
    const auto result = ask<winged_edges>(out, mesh);
    if (const auto* const fault = std::get_if<NotWinged>(&result))
        append_row(out, "faults", {static_cast<std::uint32_t>(fault->fault), fault->a, fault->b});
    else
        append_row(out, "faults", {0, 0, 0});
}

/// An answer with its length before it. The right length is that of the question's own ring, which the mesh tells.
template <auto query>
void record_answer(Recorder& out, const char* name, const WingedMesh& tables, std::uint32_t number, std::size_t length)
{
    const std::vector<std::uint32_t> answer = ask<query>(out, tables, number);
    out.append(name, static_cast<float>(answer.size()));
    append_list(out, name, answer, length);
}

void record_questions(Recorder& out, const PolygonMesh& mesh)
{
    const WingedMesh tables = tables_of(mesh);
    std::vector<std::size_t> degrees(mesh.positions.size(), 0);
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        const std::size_t corners = mesh.faces[face].size();
        record_answer<edges_round_face>(out, "edges round faces", tables, face, corners);
        record_answer<vertices_round_face>(out, "vertices round faces", tables, face, corners);
        record_answer<faces_round_face>(out, "faces round faces", tables, face, corners);
        for (const std::uint32_t corner : mesh.faces[face]) ++degrees[corner];
    }
    for (std::uint32_t vertex = 0; vertex < degrees.size(); ++vertex) {
        record_answer<edges_round_vertex>(out, "edges round vertices", tables, vertex, degrees[vertex]);
        record_answer<vertices_round_vertex>(out, "vertices round vertices", tables, vertex, degrees[vertex]);
        record_answer<faces_round_vertex>(out, "faces round vertices", tables, vertex, degrees[vertex]);
    }
}

/// What the tables of edges amount to, behind what `amount` says already.
Amount amount_of(const std::variant<WingedMesh, NotWinged>& result, Amount amount)
{
    std::vector<glm::uvec4> edges;
    if (const auto* const mesh = std::get_if<WingedMesh>(&result))
        for (const WingedEdge& e : mesh->edges) {
            edges.emplace_back(e.start, e.end, e.left, e.right);
            edges.emplace_back(e.left_previous, e.left_next, e.right_previous, e.right_next);
        }
    return amount.in_any_order(edges);
}

/// Work on meshes of four sizes: rings of quadrilaterals' triangles, double cones, where two vertices have very many
/// edges, and prisms, where two faces have. Faces come in any order, so that nobody finds the edges of a vertex sorted;
/// the tips of the cones are the smaller vertex of each of their edges, so that these stand together in any table.
void record_work(Recorder& out)
{
    for (const std::uint32_t size : {6U, 9U, 13U, 20U}) {
        Random random(size);
        const PolygonMesh ring = with_shuffled_faces(polygons_of(torus(2 * size, size)), random);
        const PolygonMesh cone = with_shuffled_faces(double_cone(2 * size * size), random);
        const PolygonMesh column = with_shuffled_faces(prism(2 * size * size), random);
        record_cost(out, "building", ring.faces.size(), [&] {
            Amount amount;
            for (const PolygonMesh& mesh : {ring, cone, column})
                amount = amount_of(ask<winged_edges>(out, mesh), amount);
            return amount;
        });
        const WingedMesh tables[] = {tables_of(ring), tables_of(cone), tables_of(column)};
        ask_in_words(out, [&] {
            return "// faces_round_face(tables, face) for each face, and vertices_round_vertex(tables, vertex) for "
                   "each\n"
                   "// vertex, of a torus of " +
                   std::to_string(2 * size) + " x " + std::to_string(size) +
                   " quadrilaterals, and of a double cone and a prism of " + std::to_string(2 * size * size) + " sides";
        });
        record_cost(out, "asking", ring.faces.size(), [&] {
            std::vector<glm::uvec2> neighbours;
            for (const WingedMesh& mesh : tables) {
                for (std::uint32_t face = 0; face < mesh.edge_of_face.size(); ++face)
                    for (const std::uint32_t other : faces_round_face(mesh, face)) neighbours.emplace_back(face, other);
                for (std::uint32_t vertex = 0; vertex < mesh.edge_of_vertex.size(); ++vertex)
                    for (const std::uint32_t other : vertices_round_vertex(mesh, vertex))
                        neighbours.emplace_back(vertex, other);
            }
            return Amount().in_any_order(neighbours);
        });
    }
    out.text("building.names", "faces");
    out.text("asking.names", "faces");
}

/// A mesh with what lies round one face (left) or round one vertex (right): the faces there, and the edges as they are
/// walked, from white to red.
void draw_round(Recorder& out, const Show& show, const PolygonMesh& mesh, std::uint32_t number, bool is_face)
{
    const auto result = ask<winged_edges>(out, mesh);
    const auto* const tables = std::get_if<WingedMesh>(&result);
    std::vector<std::uint32_t> faces;
    std::vector<std::uint32_t> edges;
    if (tables != nullptr) {
        faces = is_face ? ask<faces_round_face>(out, *tables, number) : ask<faces_round_vertex>(out, *tables, number);
        edges = is_face ? ask<edges_round_face>(out, *tables, number) : ask<edges_round_vertex>(out, *tables, number);
    }
    std::vector<glm::vec3> colors;
    std::vector<std::array<glm::vec3, 2>> lines;
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        const std::size_t place = static_cast<std::size_t>(std::ranges::find(faces, face) - faces.begin());
        const float share = static_cast<float>(place) / static_cast<float>(std::max<std::size_t>(faces.size(), 1));
        const glm::vec3 near = glm::mix(ink::blue, glm::vec3(0.10F, 0.28F, 0.55F), share);
        const glm::vec3 own = is_face && face == number ? ink::orange : glm::vec3(0.86F, 0.87F, 0.88F);
        const auto& corners = mesh.faces[face];
        colors.insert(colors.end(), corners.size() - 2, place < faces.size() ? near : own);
        for (std::size_t i = 0; i < corners.size(); ++i)
            lines.push_back({mesh.positions[corners[i]], mesh.positions[corners[(i + 1) % corners.size()]]});
    }
    show.mesh(fan_triangles(mesh), colors, {-1});
    show.lines(lines, {0.10F, 0.11F, 0.14F}, 1.2F);
    for (std::size_t i = 0; i < std::min<std::size_t>(edges.size(), 20); ++i) {
        if (edges[i] >= tables->edges.size()) continue;
        const WingedEdge& edge = tables->edges[edges[i]];
        if (edge.start >= mesh.positions.size() || edge.end >= mesh.positions.size()) continue;
        const float share = static_cast<float>(i) / static_cast<float>(edges.size());
        const std::array<glm::vec3, 2> line[] = {{mesh.positions[edge.start], mesh.positions[edge.end]}};
        show.lines(line, glm::mix(glm::vec3(1, 0.95F, 0.9F), glm::vec3(0.85F, 0.16F, 0.10F), share), 4, 4e-3F);
    }
}

/// The face that looks most towards a place.
std::uint32_t facing(const PolygonMesh& mesh, const glm::vec3& place)
{
    const auto turned_to = [&](const std::vector<std::uint32_t>& face) {
        glm::vec3 middle(0);
        for (const std::uint32_t corner : face) middle += mesh.positions[corner];
        return dot(normalize(middle), place);
    };
    const auto best = std::ranges::max_element(mesh.faces, {}, turned_to);
    return static_cast<std::uint32_t>(best - mesh.faces.begin());
}

void record_picture(Variation& vary, Recorder& out)
{
    Show show(2, 1, 300, 260);
    const glm::vec3 eye = vary.near(glm::vec3(0.7F, 0.9F, 4.6F), 0.4F);
    const PolygonMesh ball_of_faces = shuffled(football(), vary);
    show.pane(0, 0, {eye, {0, 0, 0}, 27});
    draw_round(out, show, ball_of_faces, facing(ball_of_faces, eye + glm::vec3(0, 1, -2)), true);
    const PolygonMesh globe = polygons_of(ball(vary.one_of(10U, std::array{8U, 9U, 12U}), 7, 1.05F));
    show.pane(1, 0, {{0.7F, 1.9F, 4.2F}, {0, 0, 0}, 27});
    draw_round(out, show, globe, 21, false);
    out.image("neighbours", show.picture());
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 3; ++i)
        for (const PolygonMesh& body : bodies()) record_tables(out, shuffled(body, random));
}

}

const Driver driver = {
    {"known",
     [](Case& c, Recorder& out) {
         const std::uint32_t sides = c.vary.one_of(4U, std::array{3U, 5U, 6U});
         for (const PolygonMesh& body : {polygons_of(tetrahedron()), prism(sides), PolygonMesh{}})
             record_tables(out, shuffled(body, c.vary));
     }},
    {"bodies", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"no bodies",
     [](Case& c, Recorder& out) {
         const std::vector<PolygonMesh> good = bodies();
         std::vector<PolygonMesh> bad = no_bodies();
         const std::vector<PolygonMesh> more = more_faults(c.random);
         bad.insert(bad.end(), more.begin(), more.end());
         std::size_t i = 0;
         for (const PolygonMesh& mesh : in_random_order(c.vary, bad)) {
             const std::vector<PolygonMesh> pair{shuffled(good[i++ % good.size()], c.random), shuffled(mesh, c.vary)};
             for (const PolygonMesh& one : in_random_order(c.random, pair)) record_fault(out, one);
         }
     }},
    {"questions",
     [](Case& c, Recorder& out) {
         for (const PolygonMesh& body : bodies()) record_questions(out, shuffled(body, c.random));
     }},
    {"work", [](Case&, Recorder& out) { record_work(out); }},
    {"picture", [](Case& c, Recorder& out) { record_picture(c.vary, out); }},
};

}
