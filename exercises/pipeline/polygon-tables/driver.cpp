#include <kit/amount.hpp>
#include <kit/canonical.hpp>
#include <kit/drawing.hpp>
#include <map>
#include <umbral/pipeline/polygon.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/cost.hpp>
#include <umbral/record/driver.hpp>

namespace umbral {
namespace {

using namespace pipeline;

void record_tables(Recorder& out, std::uint32_t sides)
{
    const auto code = static_cast<float>(sides);
    record_rows(out, "loop", ask<polygon_loop>(out, sides), sides);
    record_rows(out, "segments", ask<polygon_segments>(out, sides), std::size_t{2} * sides);
    const IndexedPolygon fan = ask<polygon_fan>(out, sides);
    record_rows(out, "positions", fan.positions, sides + 1);
    record_indices(out, "triangles", code, fan.triangles, sides);
    record_indices(out, "edges", code, fan.edges, std::size_t{2} * sides);
}

void record_several(Recorder& out, const std::vector<std::uint32_t>& all)
{
    std::string triangles;
    std::string edges;
    std::map<std::uint32_t, bool> named;
    for (const std::uint32_t sides : all) {
        record_tables(out, sides);
        if (named[sides]) continue;
        named[sides] = true;
        triangles += std::to_string(sides) + " triangle of " + std::to_string(sides) + "\n";
        edges += std::to_string(sides) + " edge of " + std::to_string(sides) + "\n";
    }
    out.text("triangles.names", triangles);
    out.text("edges.names", edges);
}

std::vector<std::uint32_t> random_sides(Random& random)
{
    std::vector<std::uint32_t> all;
    for (int i = 0; i < 12; ++i) all.push_back(3 + random.below(58));
    return all;
}

glm::vec3 size_of(const IndexedPolygon& polygon)
{
    return glm::vec3(static_cast<float>(polygon.positions.size()), static_cast<float>(polygon.triangles.size()),
                     static_cast<float>(polygon.edges.size()));
}

// Pairs of what is no polygon and what is one, so that neither answer to all is worth anything.
void record_sizes(Random& random, Recorder& out)
{
    for (std::uint32_t i = 0; i < 12; ++i) {
        const std::uint32_t none = i % 3;
        const std::uint32_t some = i < 3 ? 3 + i : 3 + random.below(200);
        const bool swapped = random.below(2) == 1;
        for (const std::uint32_t sides : {swapped ? some : none, swapped ? none : some}) {
            ask_in_words(out, [sides] {
                const std::string n = std::to_string(sides);
                return "polygon_loop(" + n + ").size()\npolygon_segments(" + n + ").size()";
            });
            out.append("tables", glm::vec2(static_cast<float>(polygon_loop(sides).size()),
                                           static_cast<float>(polygon_segments(sides).size())));
            out.append("fan", size_of(ask<polygon_fan>(out, sides)));
        }
    }
}

// Where segments meet: how many different corners they have, and which of the ends the last one equals first: n and 0
// if no joint gapes.
void record_joints(Random& random, Recorder& out)
{
    std::vector<std::uint32_t> all = {3, 4, 5, 7, 12, 100};
    for (int i = 0; i < 10; ++i) all.push_back(3 + random.below(400));
    for (const std::uint32_t sides : all) {
        const std::vector<glm::vec2> ends = ask<polygon_segments>(out, sides);
        std::map<std::pair<float, float>, float> first;
        float last = -1;
        for (std::size_t i = 0; i < std::min(ends.size(), std::size_t{2} * sides); ++i)
            if (!std::isnan(ends[i].x) && !std::isnan(ends[i].y))
                last = first.try_emplace({ends[i].x, ends[i].y}, static_cast<float>(i)).first->second;
        out.append("joints", glm::vec2(static_cast<float>(first.size()), last));
    }
}

void record_many(Random& random, Recorder& out)
{
    for (const std::uint32_t sides : {1000U, 3600U, 10'000U, 99'991U, 300'000U, 1'000'000U}) {
        const std::vector<glm::vec2> corners = ask<polygon_loop>(out, sides);
        for (int i = 0; i < 200; ++i) {
            const std::uint32_t place = random.below(sides);
            record_rows(out, "corners",
                        std::vector<glm::vec2>(place < corners.size() ? 1 : 0,
                                               place < corners.size() ? corners[place] : glm::vec2(0)),
                        1);
        }
    }
}

void record_work(Recorder& out)
{
    out.text("blocks.names", "sides");
    for (const std::uint32_t sides : {128U, 256U, 512U, 1024U})
        record_cost(out, "blocks", sides, [&] {
            const std::vector<glm::vec2> loop = ask<polygon_loop>(out, sides);
            const std::vector<glm::vec2> segments = ask<polygon_segments>(out, sides);
            const IndexedPolygon fan = ask<polygon_fan>(out, sides);
            return Amount().count(loop.size()).count(segments.size()).count(fan.positions.size());
        });
}

glm::vec3 hue(double turns)
{
    const glm::dvec3 wave = 0.5 + 0.5 * glm::cos(6.283185307179586 * (turns + glm::dvec3(0, 0.67, 0.33)));
    return glm::vec3(0.12 + 0.8 * wave);
}

// Left: polygons of 3, 4, 5, … sides, each in the inscribed circle of the one before; the loops drawn filled and as
// edges. Right: a fan, its triangles and its edges from the tables of indices.
Image picture(Recorder& out)
{
    Drawing drawing(640, 320, {-2.1, -1.05}, {2.1, 1.05});
    double radius = 0.95;
    for (std::uint32_t sides = 3; sides <= 10; ++sides) {
        std::vector<glm::dvec2> corners;
        for (const glm::vec2& corner : ask<polygon_loop>(out, sides)) {
            if (corners.size() > sides) break;
            corners.push_back(glm::dvec2(-1.1, -0.14) + 1.15 * radius * glm::dvec2(-corner.y, corner.x));
        }
        drawing.area(corners, hue(0.07 * sides + 0.45), 0.6);
        drawing.outline(corners, ink::white, 1.2);
        radius *= std::cos(3.14159265358979 / sides);
    }
    constexpr std::uint32_t sides = 24;
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
    {"by hand",
     [](Case&, Recorder& out) {
         record_several(out, {3, 4, 6, 12});
     }},
    {"random", [](Case& c, Recorder& out) { record_several(out, random_sides(c.random)); }},
    {"sizes", [](Case& c, Recorder& out) { record_sizes(c.random, out); }},
    {"joints", [](Case& c, Recorder& out) { record_joints(c.random, out); }},
    {"many sides", [](Case& c, Recorder& out) { record_many(c.random, out); }},
    {"work", [](Case&, Recorder& out) { record_work(out); }},
    {"picture", [](Case&, Recorder& out) { out.image("tables", picture(out)); }},
};

}
