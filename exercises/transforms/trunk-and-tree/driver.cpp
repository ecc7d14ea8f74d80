#include <array>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>
#include <umbral/transforms/tree.hpp>

#include "../drawn_events.hpp"
#include "grove.hpp"
#include "tree_order.hpp"

namespace umbral {
namespace {

using namespace transforms;

/// How often the middle of each cell was filled.
Grid<std::uint32_t> layers(const RecordingPipeline& drawn, int width, int height, glm::dvec2 low, glm::dvec2 high)
{
    Grid<std::uint32_t> sum(width, height);
    std::size_t triangles = 0;
    for (const Call& call : drawn.calls()) {
        for (std::size_t i = 0; call.kind == Call::Kind::triangles && i + 2 < call.places.size() && triangles < 100;
             i += 3, ++triangles) {
            RecordingPipeline one;
            one.compose(glm::mat4(call.modelview));
            one.fill_triangles(std::span(call.places).subspan(i, 3));
            const Grid<std::uint32_t> cells = filled_cells(one, width, height, low, high);
            for (std::size_t k = 0; k < cells.cells.size(); ++k) sum.cells[k] += cells.cells[k] != 0 ? 1U : 0U;
        }
    }
    return sum;
}

/// The start of a pipeline that turns what is drawn about the middle of a trunk, and makes it smaller, if inputs are to
/// vary.
Start turned_start(Variation& vary)
{
    const glm::vec3 middle(0.7F, 1.5F, 0);
    const glm::mat4 there = glm::translate(glm::mat4(1), middle);
    const glm::mat4 turned = there * glm::mat4(vary.turn({0, 0, 1}, 1.5F));
    const glm::vec3 size(vary.one_of(1.0F, std::array{-0.9F, -0.7F, 0.8F}), vary.near(1.0F, 0.1F), 1);
    return vary ? Start{.modelview = glm::translate(glm::scale(turned, size), -middle)} : Start{};
}

void record_trunk(Variation& vary, Recorder& out)
{
    const Start start = turned_start(vary);
    RecordingPipeline drawn(start);
    introduce(out, drawn, start);
    ask<draw_trunk>(out, drawn);
    // Of a second trunk are recorded the layers: it is drawn like the first.
    const Start second_start = turned_start(vary);
    RecordingPipeline second(second_start);
    introduce(out, second, second_start);
    // No middle of a cell lies on a line between two corners.
    const glm::dvec2 low(-0.8337, -0.3119);
    const glm::dvec2 high = low + 0.02 * glm::dvec2(160, 184);
    out.buffer("cells", filled_cells(drawn, 160, 184, low, high));
    ask<draw_trunk>(out, second);
    out.buffer("layers", layers(second, 160, 184, low, high));
}

void record_edges(Recorder& out, Random& random)
{
    for (int i = 0; i < 6; ++i) {
        Start start = i == 0 ? Start{} : random_start(random);
        // Lines thinner than a pixel among others.
        if (i % 2 == 1) start.line_width = random.uniform(0.2F, 1);
        RecordingPipeline drawn(start);
        introduce(out, drawn, start);
        ask<draw_trunk>(out, drawn);
        const std::vector<EventRow> rows = sorted_lines(drawn);
        for (const EventRow& row : rows) out.append("drawn", std::span<const float>(row));
        if (rows.empty()) continue;
        const EventRow after = matrix_row(9, drawn.modelview(), drawn.color(), drawn.line_width(), drawn.depth());
        out.append("drawn", std::span<const float>(after));
    }
    record_names(out, "drawn");
}

/// The matrices of all trunks.
std::vector<glm::dmat4> trunks_of(const RecordingPipeline& drawn)
{
    std::vector<glm::dmat4> places;
    for (const Call& call : drawn.calls())
        if (call.kind == Call::Kind::figure) places.push_back(call.modelview);
    return places;
}

// The trunks in one order, and when each was drawn; what else was drawn, and the state afterwards.
void record_trees(Recorder& out, std::initializer_list<unsigned> levels, Random& random)
{
    for (const unsigned level : levels) {
        const Start start = random_start(random);
        RecordingPipeline drawn(start);
        const Figure trunk = drawn.marker();
        introduce(out, drawn, start);
        introduce(out, trunk, "trunk");
        ask<draw_tree>(out, drawn, level, trunk);
        std::vector<Call> trunks;
        for (const Call& call : drawn.calls())
            if (call.kind == Call::Kind::figure) trunks.push_back(call);
        for (const std::size_t i : tree_order(trunks_of(drawn))) {
            const EventRow row = matrix_row(1, trunks[i].modelview, trunks[i].color, trunks[i].line_width);
            out.append("drawn", std::span<const float>(row));
            out.append("order", static_cast<std::int32_t>(i));
        }
        record_events(out, "drawn", drawn, Stack::left_out, Lines::shown, Figures::left_out);
    }
    record_names(out, "drawn");
}

/// What a matrix does to the plane z = 0: its third column is free, so that depths may be scaled or not.
glm::mat4 in_the_plane(glm::mat4 m)
{
    m[2] = glm::vec4(0, 0, 1, 0);
    return m;
}

// 2047 trunks: where an error of each level adds up.
void record_tall(Variation& vary, Recorder& out)
{
    const Start start = turned_start(vary);
    RecordingPipeline drawn(start);
    const Figure trunk = drawn.marker();
    introduce(out, drawn, start);
    introduce(out, trunk, "trunk");
    ask<draw_tree>(out, drawn, 11, trunk);
    const std::vector<glm::dmat4> places = trunks_of(drawn);
    for (const std::size_t i : tree_order(places)) out.append("trunks", in_the_plane(places[i]));
}

}

const Driver driver = {
    {"trunk", [](Case& c, Recorder& out) { record_trunk(c.vary, out); }},
    {"edges", [](Case& c, Recorder& out) { record_edges(out, c.random); }},
    {"tree",
     [](Case& c, Recorder& out) {
         record_trees(out, {1, 2, 3, 0, 6}, c.random);
     }},
    {"any tree",
     [](Case& c, Recorder& out) {
         record_trees(out, {4 + c.random.below(2), 7 + c.random.below(2)}, c.random);
     }},
    {"tall tree", [](Case& c, Recorder& out) { record_tall(c.vary, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_grove(c.vary, out)); }},
};

}
