#include <algorithm>
#include <array>
#include <kit/amount.hpp>
#include <kit/canonical.hpp>
#include <kit/drawing.hpp>
#include <kit/row_of.hpp>
#include <kit/varied.hpp>
#include <map>
#include <numeric>
#include <span>
#include <umbral/pipeline/polygon.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>

namespace umbral {
namespace {

using namespace pipeline;

/// The places of a table that are recorded: all, or of many those next to both ends, and a run anywhere.
std::vector<std::uint32_t> places_of(Random* random, std::uint32_t sides)
{
    std::vector<std::uint32_t> places(sides);
    std::iota(places.begin(), places.end(), 0U);
    if (random == nullptr || sides <= 24) return places;
    const std::uint32_t run = 4 + random->below(sides - 15);
    std::erase_if(places, [&](std::uint32_t i) { return i >= 4 && i + 4 < sides && (i < run || i >= run + 8); });
    return places;
}

/// Those that name no corner but these.
template <class Row>
std::vector<Row> at_places(std::vector<Row> rows, const std::vector<std::uint32_t>& places, std::uint32_t sides)
{
    std::erase_if(rows, [&](const Row& row) {
        for (int i = 0; i < Row::length(); ++i)
            if (row[i] < sides && !std::binary_search(places.begin(), places.end(), row[i])) return true;
        return false;
    });
    return rows;
}

void record_tables(Recorder& out, std::uint32_t sides, Random* random)
{
    const auto code = static_cast<float>(sides);
    const std::vector<std::uint32_t> places = places_of(random, sides);
    const std::vector<glm::vec2> loop = ask<polygon_loop>(out, sides);
    for (const std::uint32_t place : places) out.append("loop", row_of(loop, place));
    const std::vector<glm::vec2> segments = ask<polygon_segments>(out, sides);
    for (const std::uint32_t place : places)
        for (const std::size_t end : {0U, 1U}) out.append("segments", row_of(segments, std::size_t{2} * place + end));
    const IndexedPolygon fan = ask<polygon_fan>(out, sides);
    for (const std::uint32_t place : places) out.append("positions", row_of(fan.positions, place));
    out.append("positions", row_of(fan.positions, sides));
    record_indices(out, "triangles", code, at_places(fan.triangles, places, sides), sides);
    record_indices(out, "edges", code, at_places(fan.edges, places, sides), std::size_t{2} * sides);
}

void record_several(Recorder& out, const std::vector<std::uint32_t>& all, Random* random)
{
    std::string triangles;
    std::string edges;
    std::map<std::uint32_t, bool> named;
    for (const std::uint32_t sides : all) {
        record_tables(out, sides, random);
        if (named[sides]) continue;
        named[sides] = true;
        triangles += std::to_string(sides) + " triangle of " + std::to_string(sides) + "\n";
        edges += std::to_string(sides) + " edge of " + std::to_string(sides) + "\n";
    }
    out.text("triangles.names", triangles);
    out.text("edges.names", edges);
}

/// A few sides, as one can draw them; varied, up to 500.
std::vector<std::uint32_t> few_sides(Variation& vary)
{
    std::vector<std::uint32_t> all = {3, 4, 6, 12};
    for (std::uint32_t& sides : all) sides = any_instead(vary, sides, 5U, 496);
    return all;
}

std::vector<std::uint32_t> random_sides(Random& random)
{
    std::vector<std::uint32_t> all;
    for (int i = 0; i < 12; ++i) all.push_back(3 + random.below(i % 4 == 0 ? 58 : 498));
    return all;
}

/// All indices of a table, added up: the order of its rows is free.
template <class Row>
float sum_of(const std::vector<Row>& table)
{
    std::uint64_t sum = 0;
    for (const Row& row : table)
        for (int i = 0; i < Row::length(); ++i) sum += row[i];
    return static_cast<float>(sum % 10'007);
}

std::array<float, 5> size_of(const IndexedPolygon& polygon)
{
    return {static_cast<float>(polygon.positions.size()), static_cast<float>(polygon.triangles.size()),
            static_cast<float>(polygon.edges.size()), sum_of(polygon.triangles), sum_of(polygon.edges)};
}

void name_sizes(Recorder& out)
{
    out.columns("tables", "polygon_loop's size, polygon_segments' size");
    out.columns("fan",
                "positions, triangles, edges, sum of the triangles' indices modulo 10007, "
                "sum of the edges' indices modulo 10007");
}

/// Among others numbers that agree in their last 8 bits.
std::vector<std::uint32_t> any_sides(Random& random)
{
    const std::uint32_t few = 3 + random.below(2000);
    std::vector<std::uint32_t> all = {3, 4 + random.below(20), few, few + 256, few + 512};
    for (int i = 0; i < 7; ++i) all.push_back(3 + random.below(3000));
    return all;
}

// Pairs of what is no polygon and what is one, so that neither answer to all is worth anything.
void record_sizes(Random& random, Recorder& out)
{
    name_sizes(out);
    std::uint32_t none = 0;
    for (const std::uint32_t some : any_sides(random)) {
        const bool swapped = random.below(2) == 1;
        for (const std::uint32_t sides : {swapped ? some : none, swapped ? none : some}) {
            ask_in_words(out, [sides] {
                const std::string n = std::to_string(sides);
                return "polygon_loop(" + n + ").size()\npolygon_segments(" + n + ").size()";
            });
            out.append("tables", glm::vec2(static_cast<float>(polygon_loop(sides).size()),
                                           static_cast<float>(polygon_segments(sides).size())));
            out.append("fan", std::span<const float>(size_of(ask<polygon_fan>(out, sides))));
        }
        none = (none + 1) % 3;
    }
}

/// The last vertex that is exactly (0, 0), counted from 0; -1 if there is none.
float last_at_origin(const std::vector<glm::vec2>& positions)
{
    for (std::size_t i = positions.size(); i > 0; --i)
        if (positions[i - 1] == glm::vec2(0)) return static_cast<float>(i - 1);
    return -1;
}

// Where segments meet: how many different corners they have, and which of the ends the last one equals first: n and 0
// if no joint gapes. And of fans, how many vertices they have, and which is the centre.
void record_joints(Variation& vary, Random& random, Recorder& out)
{
    out.columns("joints", "different vertices, the last one's first place or the centre's");
    std::vector<std::uint32_t> all = {3, 4, 5, 7, 12, 100};
    for (std::uint32_t& sides : all) sides = any_instead(vary, sides, 3U, 1000);
    for (int i = 0; i < 10; ++i) all.push_back(3 + random.below(1000));
    for (const std::uint32_t sides : all) {
        const std::vector<glm::vec2> ends = ask<polygon_segments>(out, sides);
        std::map<std::pair<float, float>, float> first;
        float last = -1;
        for (std::size_t i = 0; i < std::min(ends.size(), std::size_t{2} * sides); ++i)
            if (!std::isnan(ends[i].x) && !std::isnan(ends[i].y))
                last = first.try_emplace({ends[i].x, ends[i].y}, static_cast<float>(i)).first->second;
        out.append("joints", glm::vec2(static_cast<float>(first.size()), last));
    }
    for (int i = 0; i < 4; ++i) {
        const std::vector<glm::vec2> vertices = ask<polygon_fan>(out, 4 + random.below(1000)).positions;
        out.append("joints", glm::vec2(static_cast<float>(vertices.size()), last_at_origin(vertices)));
    }
}

/// Corners anywhere, and those next to the axes, where a coordinate is small.
std::vector<std::uint32_t> some_corners(Random& random, std::uint32_t sides)
{
    std::vector<std::uint32_t> places;
    for (int i = 0; i < 80; ++i) places.push_back(random.below(sides));
    for (std::uint32_t quarter = 0; quarter < 4; ++quarter)
        for (std::uint32_t i = 0; i < 5; ++i)
            places.push_back(static_cast<std::uint32_t>(std::uint64_t{quarter} * sides / 4 + sides + i - 2) % sides);
    return places;
}

// The same corners in all three tables. Segments and fan are asked for few sides only: the growth of their work has a
// check of its own.
void record_many(Variation& vary, Random& random, Recorder& out)
{
    for (const std::uint32_t written : {1000U, 3600U, 10'000U, 99'991U, 300'000U, 999'983U, 1'000'000U}) {
        const std::uint32_t sides = any_instead(vary, written, written - written / 10, written / 10);
        const std::vector<std::uint32_t> places = some_corners(random, sides);
        const auto record = [&](const std::vector<glm::vec2>& table, std::uint32_t step) {
            for (const std::uint32_t place : places) {
                const std::size_t i = std::size_t{step} * place;
                record_rows(out, "corners", i < table.size() ? std::vector{table[i]} : std::vector<glm::vec2>(), 1);
            }
        };
        record(ask<polygon_loop>(out, sides), 1);
        if (sides > 4000) continue;
        record(ask<polygon_segments>(out, sides), 2);
        record(ask<polygon_fan>(out, sides).positions, 1);
    }
}

// Corners of a fan that are 1e-5 from each other and less: none is another's.
void record_dense(Random& random, Recorder& out)
{
    const std::uint32_t sides = 650'000 + random.below(350'000);
    const std::vector<std::uint32_t> places = some_corners(random, sides);
    const std::vector<glm::vec2> corners = ask<polygon_fan>(out, sides).positions;
    for (const std::uint32_t i : places)
        record_rows(out, "corners", i < corners.size() ? std::vector{corners[i]} : std::vector<glm::vec2>(), 1);
}

// More corners than 16 bits can number. All in one case: slow work loses this one.
void record_long(Variation& vary, Random& random, Recorder& out)
{
    name_sizes(out);
    const std::uint32_t first = any_instead(vary, 65'536U, 65'536U, 1000);
    for (const std::uint32_t sides : {first, first + 1, 67'000U + random.below(1000), 70'000U + random.below(30'000)})
        out.append("fan", std::span<const float>(size_of(ask<polygon_fan>(out, sides))));
    record_dense(random, out);
}

void record_work(Recorder& out)
{
    out.text("blocks.names", "sides");
    for (const std::uint32_t sides : {128U, 256U, 512U, 1024U})
        record_cost(out, "blocks", sides, [&] {
            const std::vector<glm::vec2> loop = ask<polygon_loop>(out, sides);
            const std::vector<glm::vec2> segments = ask<polygon_segments>(out, sides);
            const IndexedPolygon fan = ask<polygon_fan>(out, sides);
            return Amount().in_order(loop).in_order(segments).in_order(fan.positions);
        });
}

glm::vec3 hue(double turns)
{
    const glm::dvec3 wave = 0.5 + 0.5 * glm::cos(6.283185307179586 * (turns + glm::dvec3(0, 0.67, 0.33)));
    return glm::vec3(0.12 + 0.8 * wave);
}

// Left: polygons of 3, 4, 5, … sides (varied, of more), each in the inscribed circle of the one before; the loops drawn
// filled and as edges. Right: a fan, its triangles and its edges from the tables of indices.
Image picture(Variation& vary, Recorder& out)
{
    const std::uint32_t fewest = vary.one_of(3U, std::array{4U, 5U});
    Drawing drawing(640, 320, {-2.1, -1.05}, {2.1, 1.05});
    double radius = 0.95;
    for (std::uint32_t sides = fewest; sides <= 10; ++sides) {
        std::vector<glm::dvec2> corners;
        for (const glm::vec2& corner : ask<polygon_loop>(out, sides)) {
            if (corners.size() > sides) break;
            corners.push_back(glm::dvec2(-1.1, -0.14) + 1.15 * radius * glm::dvec2(-corner.y, corner.x));
        }
        drawing.area(corners, hue(0.07 * sides + 0.45), 0.6);
        drawing.outline(corners, ink::white, 1.2);
        radius *= std::cos(3.14159265358979 / sides);
    }
    const std::uint32_t sides = vary.one_of(24U, std::array{18U, 20U, 21U});
    const IndexedPolygon fan = ask<polygon_fan>(out, sides);
    const auto place = [&](std::uint32_t index) {
        return index < fan.positions.size() ? glm::dvec2(1.05, 0) + 0.95 * glm::dvec2(fan.positions[index])
                                            : glm::dvec2(NAN);
    };
    for (std::size_t i = 0; i < std::min<std::size_t>(fan.triangles.size(), sides); ++i) {
        const glm::uvec3 t = canonical(fan.triangles[i]);
        const std::vector<glm::dvec2> corners = {place(t.x), place(t.y), place(t.z)};
        drawing.area(corners, hue(t.x == 0 && t.y == sides - 1 ? 0 : (t.x + 1.0) / sides), 0.8);
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(fan.edges.size(), 3 * sides); ++i)
        drawing.line(place(fan.edges[i].x), place(fan.edges[i].y), ink::night, 2.5);
    for (std::uint32_t i = 0; i <= sides; ++i) drawing.disc(place(i), i < sides ? 4 : 7, ink::white);
    return drawing.picture();
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record_several(out, few_sides(c.vary), c.vary.random()); }},
    {"random", [](Case& c, Recorder& out) { record_several(out, random_sides(c.random), &c.random); }},
    {"sizes", [](Case& c, Recorder& out) { record_sizes(c.random, out); }},
    {"joints", [](Case& c, Recorder& out) { record_joints(c.vary, c.random, out); }},
    {"many sides", [](Case& c, Recorder& out) { record_many(c.vary, c.random, out); }},
    {"long tables", [](Case& c, Recorder& out) { record_long(c.vary, c.random, out); }},
    {"work", [](Case&, Recorder& out) { record_work(out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("tables", picture(c.vary, out)); }},
};

}
