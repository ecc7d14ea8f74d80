#include <kit/amount.hpp>
#include <kit/canonical.hpp>
#include <kit/row_of.hpp>
#include <kit/varied.hpp>
#include <optional>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>

#include "../show.hpp"
#include "lengths.hpp"
#include "voxels.hpp"

namespace umbral {
namespace {

using namespace meshes;

struct Shape {
    bool sphere;
    std::uint32_t columns, rows;

    [[nodiscard]] IndexedMesh make(Recorder& out) const
    {
        return sphere ? ask<make_sphere>(out, columns, rows) : ask<make_grid>(out, columns, rows);
    }
    [[nodiscard]] std::size_t vertices() const
    {
        return sphere ? columns * (rows - 1) + 2 : (columns + 1) * (rows + 1);
    }
    [[nodiscard]] std::size_t triangles() const { return 2 * columns * (sphere ? rows - 1 : rows); }
};

std::string name_of(const Shape& shape)
{
    return (shape.sphere ? "sphere " : "grid ") + std::to_string(shape.columns) + " x " + std::to_string(shape.rows);
}

// Of a shape with more vertices than 16 bits count, the triangles that have one of the last ten.
void record_last_triangles(Recorder& out, const Shape& shape, float code)
{
    std::vector<glm::uvec3> triangles = shape.make(out).triangles;
    const std::size_t first = shape.vertices() - 10;
    std::erase_if(triangles, [&](const glm::uvec3& t) { return std::max({t.x, t.y, t.z}) < first; });
    record_indices(out, "last triangles", code, triangles, shape.sphere ? shape.columns : 20);
}

// Their positions and triangles; of the large ones only some triangles, in a table where they are not outnumbered.
void record_shapes(Recorder& out, const std::vector<Shape>& shapes, const std::vector<Shape>& large = {})
{
    const auto name = [](std::size_t i, const Shape& shape) {
        return std::to_string(i) + " triangle of the " + name_of(shape) + "\n";
    };
    std::string names;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const IndexedMesh mesh = shapes[i].make(out);
        record_rows(out, "positions", mesh.positions, shapes[i].vertices());
        record_indices(out, "triangles", static_cast<float>(i), mesh.triangles, shapes[i].triangles());
        names += name(i, shapes[i]);
    }
    out.text("triangles.names", names);
    if (large.empty()) return;
    names.clear();
    for (std::size_t i = 0; i < large.size(); ++i) {
        record_last_triangles(out, large[i], static_cast<float>(i));
        names += name(i, large[i]);
    }
    out.text("last triangles.names", names);
}

/// Shapes that are written down; varied, of up to 24 more columns and rows.
std::vector<Shape> varied(Variation& vary, std::vector<Shape> shapes)
{
    if (Random* const random = vary.random())
        for (Shape& shape : shapes)
            for (std::uint32_t* const count : {&shape.columns, &shape.rows}) *count += 1 + random->below(24);
    return shapes;
}

/// In rows of the same kind, each of which has much in common with the one before: as many vertices and triangles, the
/// same numbers the other way round, as many columns, or as many rows.
std::vector<Shape> random_shapes(Random& random)
{
    std::vector<Shape> shapes;
    for (int i = 0; i < 4; ++i) {
        const bool sphere = i % 2 == 0;
        const std::uint32_t columns = 3 + random.below(24);
        const std::uint32_t rows = 3 + random.below(20);
        const std::uint32_t more = sphere ? 1 : 0;
        shapes.push_back({sphere, columns, rows + more});
        shapes.push_back({sphere, rows, columns + more});
        shapes.push_back({sphere, columns + more, rows});
        shapes.push_back({sphere, columns + more, rows + 1 + random.below(9)});
        shapes.push_back({sphere, columns + more + 1 + random.below(9), shapes.back().rows});
    }
    return shapes;
}

void record_size(Recorder& out, const Shape& shape)
{
    const IndexedMesh mesh = shape.make(out);
    out.append("tables",
               glm::vec2(static_cast<float>(mesh.positions.size()), static_cast<float>(mesh.triangles.size())));
}

// Pairs of a shape that there is and one that there is not. Half of the first are the smallest of their kind.
void record_sizes(Random& random, Recorder& out)
{
    const std::uint32_t many = 3 + random.below(400);
    const Shape none[] = {{false, 0, many},    {false, many + 1, 0}, {true, 2, many + 2}, {true, many + 3, 1},
                          {true, 0, many + 4}, {false, 0, 0},        {true, 1, many + 5}, {true, many + 6, 0}};
    const std::uint32_t few = 4 + random.below(20);
    const std::vector<Shape> smallest = {{true, 3, 2},  {true, 4, 2}, {true, few, 2},  {true, 3, few},
                                         {false, 1, 1}, {true, 3, 2}, {false, few, 1}, {true, 3, 2}};
    for (const Shape& small : in_random_order(random, smallest)) {
        const std::uint32_t columns = 3 + random.below(60);
        const Shape usual{random.below(2) == 0, columns, 2 + random.below(60)};
        for (const Shape& some : {small, usual}) {
            const Shape& empty = none[random.below(8)];
            const bool swapped = random.below(2) == 0;
            record_size(out, swapped ? some : empty);
            record_size(out, swapped ? empty : some);
        }
    }
}

/// Bytes on the surface of a ball.
void record_surface(Random& random, Recorder& out, const char* name, std::uint32_t k,
                    const std::vector<std::uint8_t>& bytes)
{
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 place = static_cast<double>(k) * (0.5 + 0.5 * glm::dvec3(random.unit_vector()));
        const glm::uvec3 cell = min(glm::uvec3(place), glm::uvec3(k - 1));
        const std::size_t byte = (cell.x + std::size_t{k} * (cell.y + std::size_t{k} * cell.z)) / 8;
        out.append(name, row_of(bytes, byte));
    }
}

/// Its rows are more than 16 bits count.
void record_large_ball(Random& random, Recorder& out)
{
    const std::uint32_t k = 260 + random.below(60);
    record_surface(random, out, "bytes of a large ball", k, ask<make_voxel_sphere>(out, k));
}

void record_voxels(Variation& vary, Recorder& out)
{
    // A single voxel too many or too few is one byte of many: how many are filled tells all balls with one apart.
    out.columns("sizes", "bytes, last byte, filled voxels");
    std::vector sides{1U, 2U, 3U, 4U, 5U, 8U, 11U, 16U, 20U};
    Random* const random = vary.random();
    if (random != nullptr)
        for (std::uint32_t& side : sides) side = 6 + random->below(195);
    for (const std::uint32_t k : sides) {
        const std::vector<std::uint8_t> bytes = ask<make_voxel_sphere>(out, k);
        out.append("sizes", glm::vec3(bytes.size(), bytes.empty() ? NAN : bytes.back(), filled(bytes, k)));
        if (random != nullptr)
            record_surface(*random, out, "bytes", k, bytes);
        else
            for (std::size_t i = 0; i < (k * k * k + 7) / 8; ++i) out.append("bytes", row_of(bytes, i));
    }
}

void record_border(Variation& vary, Random& random, Recorder& out)
{
    for (const std::uint32_t written :
         {24U, 200U, 5000U, 65'536U, 1'000'001U, 100'000'000U, 400'000'003U, 900'000'001U, 1'073'741'824U}) {
        Random* const other = vary.random();
        const std::uint32_t k = other != nullptr ? written - other->below(written / 10) : written;
        for (int i = 0; i < 40; ++i) {
            const auto [inside, outside] = i % 4 == 1 ? layer_voxels(random, k) : border_voxels(random, k, i % 2 == 0);
            const bool swapped = random.below(2) == 0;
            out.append("inside", ask<voxel_is_inside>(out, k, swapped ? outside : inside));
            out.append("inside", ask<voxel_is_inside>(out, k, swapped ? inside : outside));
        }
    }
}

// Of several lengths of a row. Of grids most places are where floats are largest, and their last digits, too.
void record_fine(Random& random, Recorder& out)
{
    std::vector<Shape> shapes = {{true, 20'000 + random.below(1000), 18 + random.below(3)},
                                 {true, 3, 90'000 + random.below(10'000)},
                                 {true, 350 + random.below(20), 700 + random.below(40)}};
    for (int i = 0; i < 2; ++i) {
        shapes.push_back({false, awkward_length(random), 1});
        shapes.push_back({false, 1, awkward_length(random)});
    }
    for (const Shape& shape : shapes) {
        const IndexedMesh mesh = shape.make(out);
        for (int i = 0; i < 200; ++i) {
            auto place = random.below(static_cast<std::uint32_t>(shape.vertices()));
            if (!shape.sphere && i % 4 != 0) place = static_cast<std::uint32_t>(shape.vertices()) - 1 - place / 3;
            out.append(shape.sphere ? "sphere" : "grid", row_of(mesh.positions, place));
        }
    }
}

void record_work(Recorder& out)
{
    out.text("blocks.names", "cells");
    for (const std::uint32_t side : {8U, 12U, 16U, 24U, 32U})
        record_cost(out, "blocks", side * side, [&] {
            const IndexedMesh grid = ask<make_grid>(out, side, side);
            const IndexedMesh sphere = ask<make_sphere>(out, side, side);
            return Amount()
                .in_order(grid.positions)
                .count(grid.triangles.size())
                .in_order(sphere.positions)
                .count(sphere.triangles.size());
        });
}

glm::vec3 tint(double turns)
{
    return glm::vec3(0.55 + 0.33 * glm::cos(6.283185307179586 * (turns + glm::dvec3(0, 0.62, 0.36))));
}

// Colours by where a triangle's first corner lies; a student's triangles may name anything.
template <class Hue>
std::vector<glm::vec3> colored(IndexedMesh& mesh, std::size_t most, Hue hue)
{
    mesh.triangles.resize(std::min(mesh.triangles.size(), most));
    std::vector<glm::vec3> colors;
    for (const glm::uvec3& t : mesh.triangles) {
        const std::size_t count = mesh.positions.size();
        const bool named = t.x < count && t.y < count && t.z < count;
        colors.push_back(named ? tint(hue((mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0F))
                               : glm::vec3(0));
    }
    return colors;
}

// The grid, bent into a wave; the sphere by meridians and parallels; the sphere of voxels.
Image picture(Variation& vary, Recorder& out)
{
    constexpr std::array others{11U, 13U, 18U};
    Show show(3, 1, 240, 240);
    const Look edges{1.2F, {0.3F, 0.05F, 0.05F}, 0.85F};

    IndexedMesh grid = ask<make_grid>(out, vary.one_of(14U, others), 14);
    grid.positions.resize(std::min<std::size_t>(grid.positions.size(), 1000));
    for (glm::vec3& p : grid.positions) {
        const glm::vec2 q = 2.0F * glm::vec2(p) - 1.0F;
        p = {1.02F * q.x, 0.28F * std::cos(4.5F * glm::length(q)) * std::exp(-glm::length(q)), -1.02F * q.y};
    }
    show.pane(0, 0, {{1.6F, 2.7F, 3.6F}, {0, -0.1F, 0}, 36});
    show.mesh(grid, colored(grid, 2000, [](glm::vec3 p) { return 0.5 + 1.4 * p.y; }), edges);

    IndexedMesh sphere = ask<make_sphere>(out, vary.one_of(24U, others), 16);
    show.pane(1, 0, {{1.3F, 1.5F, 3.2F}, {0, 0, 0}, 21});
    show.mesh(sphere, colored(sphere, 4000, [](glm::vec3 p) { return 0.5 + 0.6 * p.y; }), edges);

    const std::uint32_t side = vary.one_of(20U, others);
    IndexedMesh voxels = surface(ask<make_voxel_sphere>(out, side), static_cast<int>(side));
    show.pane(2, 0, {{1.3F, 1.5F, 3.2F}, {0, 0, 0}, 21});
    show.mesh(voxels, colored(voxels, 20'000, [](glm::vec3 p) { return 0.5 + 0.6 * p.y; }), {0, {0, 0, 0}, 0});
    return show.picture();
}

}

const Driver driver = {
    {"grid",
     [](Case& c, Recorder& out) {
         record_shapes(out, varied(c.vary, {{false, 1, 1}, {false, 2, 1}, {false, 1, 3}, {false, 8, 4}}));
     }},
    {"sphere",
     [](Case& c, Recorder& out) {
         record_shapes(out, varied(c.vary, {{true, 4, 2}, {true, 3, 3}, {true, 6, 4}, {true, 12, 9}}));
     }},
    {"random",
     [](Case& c, Recorder& out) {
         Random& random = c.random;
         const std::uint32_t slices = 12 + random.below(4);
         const std::vector<Shape> large = {{false, 950 + random.below(200), 70 + random.below(8)},
                                           {true, slices, 6000 + random.below(1000)}};
         record_shapes(out, random_shapes(random), large);
     }},
    {"sizes", [](Case& c, Recorder& out) { record_sizes(c.random, out); }},
    {"voxels",
     [](Case& c, Recorder& out) {
         record_voxels(c.vary, out);
         record_large_ball(c.random, out);
     }},
    {"border", [](Case& c, Recorder& out) { record_border(c.vary, c.random, out); }},
    {"fine", [](Case& c, Recorder& out) { record_fine(c.random, out); }},
    {"work", [](Case&, Recorder& out) { record_work(out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("shapes", picture(c.vary, out)); }},
};

}
