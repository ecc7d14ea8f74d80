#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <kit/drawing.hpp>
#include <kit/varied.hpp>
#include <string>
#include <umbral/meshes/sizes.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>
#include <umbral/record/variation.hpp>
#include <utility>

namespace umbral {
namespace {

using namespace meshes;

// All 64 bits, in numbers of at most seven digits, which a float holds as they are.
constexpr const char* in_millions = "million millions, millions, units";

glm::vec3 by_millions(std::uint64_t value)
{
    constexpr std::uint64_t million = 1'000'000;
    return {static_cast<float>(value / million / million), static_cast<float>(value / million % million),
            static_cast<float>(value % million)};
}

void record(Recorder& out, const char* name, std::uint64_t value)
{
    out.columns(name, in_millions);
    out.append(name, by_millions(value));
}

// Several numbers of one answer, a row each: the first says which it is, by what `names` calls them.
void record_each(Recorder& out, const char* name, const char* names, std::initializer_list<std::uint64_t> values)
{
    out.columns(name, std::string("number (") + names + "), " + in_millions);
    float which = 0;
    for (const std::uint64_t value : values) out.append(name, glm::vec4(which++, by_millions(value)));
}

void record_counts(Recorder& out, std::uint64_t columns, std::uint64_t rows)
{
    const GridCounts counts = ask<grid_counts>(out, columns, rows);
    record_each(out, "counts", "0: vertices; 1: edges; 2: triangles",
                {counts.vertices, counts.edges, counts.triangles});
}

void record_bytes(Recorder& out, std::uint64_t columns, std::uint64_t rows, const EntryBytes& bytes)
{
    const GridBytes sizes = ask<grid_bytes>(out, columns, rows, bytes);
    record(out, "isolated", sizes.isolated);
    record(out, "indexed", sizes.indexed);
    record(out, "strips", sizes.strips);
    record(out, "indexed strips", sizes.indexed_strips);
}

void record_work(Recorder& out, std::uint64_t columns, std::uint64_t rows)
{
    const GridWork work = ask<grid_work>(out, columns, rows);
    record_each(out, "work", "0: isolated; 1: indexed; 2: strips", {work.isolated, work.indexed, work.strips});
}

EntryBytes random_entries(Random& random)
{
    EntryBytes bytes;
    bytes.vertex = 1 + random.below(100);
    bytes.index = 1 + random.below(12);
    bytes.pointer = 1 + random.below(16);
    return bytes;
}

/// As usual; varied, others.
EntryBytes usual_bytes(Variation& vary)
{
    Random* const random = vary.random();
    return random != nullptr ? random_entries(*random) : EntryBytes{12, 4, 8};
}

void record_sphere(Variation& vary, Recorder& out)
{
    // Below 1626, so that k³ bits have a number of 32 bits.
    for (const std::uint64_t k : {1U, 2U, 3U, 5U, 8U, 16U, 17U, 31U, 100U, 288U, 1024U})
        record(out, "voxels", ask<voxel_bytes>(out, any_instead<std::uint64_t>(vary, k, 1, 1625)));
    record(out, "voxels", ask<voxel_bytes>(out, 2'097'152));  // the most that there may be: 2^63 bits
    for (const std::uint64_t k : {2U, 3U, 8U, 16U, 17U, 100U, 287U, 288U, 1024U})
        record(out, "mesh",
               ask<sphere_mesh_bytes>(out, 1 + any_instead<std::uint64_t>(vary, k - 1, 1, 2000), usual_bytes(vary)));
    for (const auto& [vertex, index] : {std::pair{12U, 4U}, {24U, 4U}, {12U, 2U}, {1U, 1U}, {6U, 8U}, {44U, 4U}}) {
        const std::uint64_t vertex_bytes = any_instead<std::uint64_t>(vary, vertex, 1, 200);
        const std::uint64_t index_bytes = any_instead<std::uint64_t>(vary, index, 1, 16);
        record(out, "crossover", ask<crossover_resolution>(out, EntryBytes{vertex_bytes, index_bytes, 8}));
    }
}

void record_grid(Variation& vary, Recorder& out)
{
    for (const auto& [written_columns, written_rows] :
         {std::pair{1U, 1U}, {8U, 4U}, {4U, 8U}, {1U, 7U}, {9U, 1U}, {128U, 128U}, {1000U, 10U}}) {
        // A single column stays one, and so does a single row.
        const bool low = written_rows == 1 && written_columns > 1;
        const std::uint64_t columns =
            written_columns == 1 ? 1 : any_instead<std::uint64_t>(vary, written_columns, 2, 1500);
        const std::uint64_t rows = low ? 1 : any_instead<std::uint64_t>(vary, written_rows, 1, 1500);
        record_counts(out, columns, rows);
        record_bytes(out, columns, rows, usual_bytes(vary));
        record_work(out, columns, rows);
    }
}

// Of all sizes that there are: small ones mostly, and one in three of up to 4096.
EntryBytes entries_of_any_size(Random& random)
{
    EntryBytes bytes = random_entries(random);
    for (std::uint64_t* const size : {&bytes.vertex, &bytes.index, &bytes.pointer})
        if (random.below(3) == 0) *size = 1 + random.below(4096);
    return bytes;
}

// Grids and tables of which one number only is another one than before: a side by one, the sides exchanged or equal,
// the size of one kind of entry, which may be that of another.
void record_changed(Random& random, Recorder& out)
{
    for (int i = 0; i < 6; ++i) {
        EntryBytes bytes = random_entries(random);
        glm::u64vec2 cells(1 + random.below(3), 1 + random.below(40));
        const auto record_all = [&] {
            record_counts(out, cells.x, cells.y);
            record_bytes(out, cells.x, cells.y, bytes);
        };
        for (const glm::u64vec2& other : {cells,
                                          {cells.x + 1, cells.y},
                                          {cells.x + 1, cells.y + 1},
                                          {cells.y + 1, cells.x + 1},
                                          {cells.y, cells.y}}) {
            cells = other;
            record_all();
        }
        for (std::uint64_t* const size : {&bytes.index, &bytes.pointer, &bytes.vertex, &bytes.index}) {
            *size = i % 2 == 0 ? *size + 1 + random.below(20) : size == &bytes.index ? bytes.pointer : bytes.index;
            record_all();
            record(out, "sphere", ask<sphere_mesh_bytes>(out, cells.y + 1, bytes));
            record(out, "crossover", ask<crossover_resolution>(out, bytes));
        }
    }
}

void record_random(Random& random, Recorder& out)
{
    record_changed(random, out);
    for (int i = 0; i < 60; ++i) {
        const EntryBytes bytes = entries_of_any_size(random);
        const std::uint64_t columns = i % 8 == 0 ? 1 : 1 + random.below(5000);
        const std::uint64_t rows = i % 8 == 1 ? 1 : 1 + random.below(5000);
        record(out, "sphere", ask<voxel_bytes>(out, columns));
        record(out, "sphere", ask<sphere_mesh_bytes>(out, rows + 1, bytes));
        record(out, "crossover", ask<crossover_resolution>(out, bytes));
        record_counts(out, columns, rows);
        record_bytes(out, columns, rows, bytes);
    }
}

// As many cells as results of 63 bits allow; the shorter side has any number of bits.
std::pair<std::uint64_t, std::uint64_t> large_grid(Random& random, const EntryBytes& bytes)
{
    const std::uint64_t most = (std::uint64_t{1} << 63U) / (6 * bytes.vertex + 6 * bytes.index + bytes.pointer);
    const std::uint64_t cells = most - random.below(1000) * (most / 2000);
    const std::uint64_t power = std::uint64_t{1} << random.below(26);
    const std::uint64_t shorter = power + random.below(static_cast<std::uint32_t>(power));
    const std::uint64_t longer = cells / shorter;
    return random.below(2) == 0 ? std::pair(shorter, longer) : std::pair(longer, shorter);
}

// Results of up to 63 bits, where doubles lie up to 1024 apart; and the finest voxels that there may be.
void record_large(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        const EntryBytes bytes = i % 4 < 2 ? random_entries(random) : entries_of_any_size(random);
        constexpr std::uint64_t most = 2'097'152;
        const std::uint64_t k = i % 2 == 0 ? most : 1'000'000 + random.below(most - 1'000'000);
        record(out, "sizes", ask<voxel_bytes>(out, k));
        record(out, "sizes", ask<sphere_mesh_bytes>(out, k, bytes));
        const auto [columns, rows] = large_grid(random, bytes);
        const GridCounts counts = ask<grid_counts>(out, columns, rows);
        for (const std::uint64_t count : {counts.vertices, counts.edges, counts.triangles}) record(out, "sizes", count);
        const GridWork work = ask<grid_work>(out, columns, rows);
        for (const std::uint64_t count : {work.isolated, work.indexed, work.strips}) record(out, "sizes", count);
        const GridBytes sizes = ask<grid_bytes>(out, columns, rows, bytes);
        for (const std::uint64_t value : {sizes.isolated, sizes.indexed, sizes.strips, sizes.indexed_strips})
            record(out, "sizes", value);
    }
}

// Both axes logarithmic: k from 2 to 2048, bytes from 1 to 2^31.
glm::dvec2 on_chart(std::uint64_t k, std::uint64_t bytes)
{
    return {0.55 * std::log2(static_cast<double>(std::max<std::uint64_t>(k, 1))),
            0.18 * std::log2(static_cast<double>(std::max<std::uint64_t>(bytes, 1)))};
}

// Left: bytes of voxels and of meshes for all resolutions, and where they cross. Right: bytes per vertex of a large
// grid, a square each, those of coordinates in orange; isolated triangles, indexed, strips, indexed strips.
Image picture(Variation& vary, Recorder& out)
{
    const EntryBytes bytes_each{vary.one_of(12U, std::array{8U, 10U, 16U}), 4, 8};
    EntryBytes twice = bytes_each;
    twice.vertex *= 2;
    Drawing drawing(640, 340, {-0.2, -0.45}, {11.6, 5.8});
    for (int e = 0; e <= 30; e += 5)
        drawing.line(on_chart(2, std::uint64_t{1} << e), on_chart(2048, std::uint64_t{1} << e), ink::slate, 1);
    for (int e = 1; e <= 11; e += 2)
        drawing.line(on_chart(std::uint64_t{1} << e, 1), on_chart(std::uint64_t{1} << e, std::uint64_t{1} << 30U),
                     ink::slate, 1);
    const auto chart = [&](auto bytes, glm::vec3 color) {
        for (std::uint64_t k = 2; k < 2048; k += 1 + k / 8) {
            const std::uint64_t next = std::min<std::uint64_t>(k + 1 + k / 8, 2048);
            drawing.line(on_chart(k, bytes(k)), on_chart(next, bytes(next)), color, 4);
        }
    };
    chart([&](std::uint64_t k) { return ask<voxel_bytes>(out, k); }, ink::blue);
    chart([&](std::uint64_t k) { return ask<sphere_mesh_bytes>(out, k, bytes_each); }, ink::orange);
    const std::uint64_t crossing = ask<crossover_resolution>(out, bytes_each);
    const glm::dvec2 crossed = on_chart(crossing, ask<voxel_bytes>(out, crossing));
    drawing.line(on_chart(crossing, 1), crossed, ink::white, 1.5);
    drawing.ring(crossed, 9, ink::white, 2.5);

    constexpr std::uint64_t side = 4096;
    const GridBytes sizes = ask<grid_bytes>(out, side, side, bytes_each);
    const GridBytes doubled = ask<grid_bytes>(out, side, side, twice);
    const auto per_vertex = [](std::uint64_t bytes) {
        return std::min(static_cast<int>(std::lround(static_cast<double>(bytes) / double{side * side})), 96);
    };
    const std::pair<std::uint64_t, std::uint64_t> bars[] = {{sizes.isolated, doubled.isolated},
                                                            {sizes.indexed, doubled.indexed},
                                                            {sizes.strips, doubled.strips},
                                                            {sizes.indexed_strips, doubled.indexed_strips}};
    double left = 6.9;
    for (const auto& [bytes, with_double_vertices] : bars) {
        const int coordinates = per_vertex(with_double_vertices - bytes);
        for (int i = 0; i < per_vertex(bytes); ++i) {
            const glm::dvec2 p(left + 0.25 * (i % 4), 0.297 * static_cast<double>(i / 4));
            drawing.area(std::vector<glm::dvec2>{p, p + glm::dvec2(0.21, 0), p + glm::dvec2(0.21, 0.25),
                                                 p + glm::dvec2(0, 0.25)},
                         i < coordinates ? ink::orange : ink::green);
        }
        left += 1.2;
    }
    return drawing.picture();
}

}

const Driver driver = {
    {"sphere", [](Case& c, Recorder& out) { record_sphere(c.vary, out); }},
    {"grid", [](Case& c, Recorder& out) { record_grid(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"large", [](Case& c, Recorder& out) { record_large(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("chart", picture(c.vary, out)); }},
};

}
