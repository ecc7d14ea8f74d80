#include "render/fields/isosurface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace umbral::render::fields {
namespace {

constexpr int block_side = 8;  ///< cells that are looked at, or left out, together
constexpr int smoothings = 3;

struct Mesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::uvec3> triangles;
};

/// Corners of a cell are numbered by bits: 1 is one step along x, 2 along y, 4 along z. Each tetrahedron goes from
/// corner 0 to corner 7, one axis after the other; positive: its last three are counter-clockwise seen from outside.
constexpr std::array<std::array<unsigned, 4>, 6> tetrahedra = {
    {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 3, 2, 7}, {0, 6, 4, 7}, {0, 5, 1, 7}}};

glm::ivec3 steps(unsigned corner) { return {corner & 1U, (corner >> 1U) & 1U, corner >> 2U}; }

class March {
public:
    March(const Distance& field, int cells)
        : field_(field),
          cells_(cells),
          step_(2.0 / cells),
          values_(static_cast<std::size_t>(cells + 1) * static_cast<std::size_t>(cells + 1) *
                      static_cast<std::size_t>(cells + 1),
                  std::numeric_limits<float>::quiet_NaN())
    {
    }

    Mesh run()
    {
        for (int z = 0; z < cells_; z += block_side)
            for (int y = 0; y < cells_; y += block_side)
                for (int x = 0; x < cells_; x += block_side) add_block({x, y, z});
        return std::move(mesh_);
    }

private:
    [[nodiscard]] glm::dvec3 place(const glm::ivec3& point) const { return glm::dvec3(point) * step_ - 1.0; }

    [[nodiscard]] std::size_t index(const glm::ivec3& point) const
    {
        const auto side = static_cast<std::size_t>(cells_) + 1;
        return (static_cast<std::size_t>(point.z) * side + static_cast<std::size_t>(point.y)) * side +
               static_cast<std::size_t>(point.x);
    }

    [[nodiscard]] bool is_inside(const glm::ivec3& point)
    {
        float& value = values_[index(point)];
        if (std::isnan(value)) value = static_cast<float>(field_(place(point)));
        return value < 0;
    }

    void add_block(const glm::ivec3& first)
    {
        const glm::dvec3 half(0.5 * block_side * step_);
        // A little more than half the diagonal, as estimates of distances may be a little too large.
        if (std::abs(field_(place(first) + half)) > 1.1 * length(half)) return;
        const glm::ivec3 end = glm::min(first + block_side, glm::ivec3(cells_));
        for (int z = first.z; z < end.z; ++z)
            for (int y = first.y; y < end.y; ++y)
                for (int x = first.x; x < end.x; ++x) add_cell({x, y, z});
    }

    void add_cell(const glm::ivec3& cell)
    {
        unsigned inside = 0;
        for (unsigned corner = 0; corner < 8; ++corner) inside |= is_inside(cell + steps(corner)) ? 1U << corner : 0U;
        if (inside == 0 || inside == 255) return;
        for (const auto& tetrahedron : tetrahedra) add_tetrahedron(cell, tetrahedron, inside);
    }

    void add_tetrahedron(const glm::ivec3& cell, std::array<unsigned, 4> corners, unsigned inside)
    {
        const auto is_in = [&](unsigned corner) { return (inside >> corner & 1U) != 0; };
        // Those inside come first; every exchange turns the sense round.
        bool turned = false;
        for (std::size_t pass = 0; pass < 3; ++pass)
            for (std::size_t i = 0; i < 3; ++i)
                if (!is_in(corners[i]) && is_in(corners[i + 1])) {
                    std::swap(corners[i], corners[i + 1]);
                    turned = !turned;
                }
        const auto [a, b, c, d] = corners;
        const auto cut = [&](unsigned from, unsigned to) { return crossing(cell, from, to); };
        switch (std::count_if(corners.begin(), corners.end(), is_in)) {
            case 1: add_triangle(cut(a, b), cut(a, c), cut(a, d), turned); break;
            case 2:
                add_triangle(cut(a, c), cut(a, d), cut(b, d), turned);
                add_triangle(cut(a, c), cut(b, d), cut(b, c), turned);
                break;
            case 3: add_triangle(cut(a, d), cut(b, d), cut(c, d), turned); break;
            default: break;
        }
    }

    void add_triangle(unsigned a, unsigned b, unsigned c, bool turned)
    {
        mesh_.triangles.push_back(turned ? glm::uvec3(a, c, b) : glm::uvec3(a, b, c));
    }

    /// The vertex on an edge between two corners of a cell; cells that share the edge share it.
    unsigned crossing(const glm::ivec3& cell, unsigned one, unsigned other)
    {
        const glm::ivec3 from = cell + steps(std::min(one, other));
        const glm::ivec3 to = cell + steps(std::max(one, other));
        const std::uint64_t edge = index(from) * 8 + (one ^ other);
        const auto [known, is_new] = vertices_.try_emplace(edge, static_cast<unsigned>(mesh_.positions.size()));
        if (is_new) mesh_.positions.push_back(root_between(place(from), place(to)));
        return known->second;
    }

    /// Where the field is 0, between two places of which one is inside: false position, by the Illinois rule.
    [[nodiscard]] glm::dvec3 root_between(const glm::dvec3& from, const glm::dvec3& to) const
    {
        double low = 0;
        double high = 1;
        double at_low = field_(from);
        double at_high = field_(to);
        double share = 0.5;
        int side = 0;
        for (int i = 0; i < 40; ++i) {
            share = at_high == at_low ? 0.5 : (low * at_high - high * at_low) / (at_high - at_low);
            const double value = field_(glm::mix(from, to, share));
            if (std::abs(value) <= 1e-4 * step_) break;
            const bool is_low = (value < 0) == (at_low < 0);
            (is_low ? low : high) = share;
            (is_low ? at_low : at_high) = value;
            if (side == (is_low ? -1 : 1)) (is_low ? at_high : at_low) *= 0.5;
            side = is_low ? -1 : 1;
        }
        return glm::mix(from, to, share);
    }

    const Distance& field_;
    int cells_;
    double step_;
    std::vector<float> values_;  ///< at the grid's points, where they were asked for
    std::unordered_map<std::uint64_t, unsigned> vertices_;
    Mesh mesh_;
};

/// The field's slope, from four places round a point.
glm::dvec3 slope(const Distance& field, const glm::dvec3& place, double step)
{
    constexpr std::array<glm::dvec3, 4> corners = {{{1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {1, 1, 1}}};
    glm::dvec3 sum(0);
    for (const glm::dvec3& corner : corners) sum += corner * field(place + step * corner);
    return sum / (4 * step);
}

/// Moves every vertex to the middle of its neighbours, and from there back to the surface by Newton's rule; where that
/// does not lead to it, the vertex stays.
void even_out(const Distance& field, double cell, Mesh& mesh)
{
    std::vector<glm::dvec4> sums(mesh.positions.size(), glm::dvec4(0));
    for (const glm::uvec3& triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            sums[triangle[i]] += glm::dvec4(mesh.positions[triangle[(i + 1) % 3]], 1) +
                                 glm::dvec4(mesh.positions[triangle[(i + 2) % 3]], 1);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        glm::dvec3 place = glm::dvec3(sums[i]) / sums[i].w;
        double value = field(place);
        for (int pass = 0; pass < 3 && std::abs(value) > 1e-3 * cell; ++pass) {
            const glm::dvec3 gradient = slope(field, place, 0.01 * cell);
            place -= value / std::max(0.25, dot(gradient, gradient)) * gradient;
            value = field(place);
        }
        if (std::abs(value) <= 1e-3 * cell && distance(place, mesh.positions[i]) < cell) mesh.positions[i] = place;
    }
}

}

meshes::IndexedMesh isosurface(const Distance& field, int cells)
{
    Mesh mesh = March(field, cells).run();
    for (int i = 0; i < smoothings; ++i) even_out(field, 2.0 / cells, mesh);
    return {{mesh.positions.begin(), mesh.positions.end()}, std::move(mesh.triangles)};
}

}
