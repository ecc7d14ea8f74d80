#include <array>
#include <optional>
#include <umbral/gl/record_trace.hpp>
#include <umbral/record/driver.hpp>

#include "stage.hpp"
#include "state.hpp"

namespace umbral {
namespace {

using namespace pipeline;

void record_picture(Recorder& out, int size, const std::vector<Piece>& pieces)
{
    const Stage stage(size);
    for (const Piece& piece : pieces) draw(out, piece);
    out.image("picture", stage.picture());
}

/// Pieces that are written down.
void record_written(Case& c, Recorder& out, int size, std::vector<Piece> pieces)
{
    for (Piece& piece : pieces) piece = varied(c.vary, piece);
    record_picture(out, size, pieces);
}

void record_calls(Case& c, Recorder& out, std::string_view name, bool cut)
{
    const int count = c.vary.one_of(9, std::array{5, 7, 13});  // odd: triangles come two after each other
    const std::vector<glm::vec2> corners = polygon(count);
    const Fan tables = fan(count, 2);
    gl::begin_trace();
    if (cut)
        ask<draw_triangles>(out, tables.positions, tables.indices, {1, 0, 0}, {1, 1, 1});
    else
        ask<draw_polygon>(out, corners, {1, 0, 0}, {1, 1, 1});
    gl::record_trace(out, name, gl::end_trace());
}

void calls(Case& c, Recorder& out)
{
    const Stage stage(32);
    record_calls(c, out, "polygon", false);
    record_calls(c, out, "triangles", true);
}

// Nearer pieces come first, so that the edges of farther ones must stop at them.
void depth_test(Case& c, Recorder& out)
{
    glEnable(GL_DEPTH_TEST);
    record_written(c, out, 192,
                   {{5, false, {-0.3F, 0.3F, -0.5F}, 0.4F, 0.3F, {0.2F, 0.5F, 0.8F}, {0.8F, 0.95F, 1}},
                    {8, true, {0.35F, -0.2F, -0.4F}, 0.4F, 0.1F, {0.75F, 0.3F, 0.2F}, {1, 0.9F, 0.8F}},
                    {7, true, {-0.25F, -0.3F, 0.2F}, 0.6F, 0.2F, {0.15F, 0.5F, 0.3F}, {0.7F, 1, 0.8F}},
                    {6, false, {0.25F, 0.25F, 0.6F}, 0.7F, 0, {0.5F, 0.35F, 0.6F}, {0.95F, 0.85F, 1}}});
}

void buffer_bound(Case& c, Recorder& out)
{
    const BoundBuffer buffer;
    record_written(c, out, 128,
                   {{6, false, {-0.45F, 0.1F, 0}, 0.45F, 0.2F, {0.2F, 0.6F, 0.5F}, {1, 1, 1}},
                    {9, true, {0.45F, -0.1F, 0}, 0.45F, 0, {0.7F, 0.5F, 0.1F}, {1, 1, 1}}});
}

// Both functions in eight rounds, twice in each: the second time with another table of the same size.
void state(Case& c, Recorder& out)
{
    const Stage stage(64);
    for (int round = 0; round < 16; ++round) {
        const int turn = round / 2;
        Piece piece = random_piece(c.random, 0);
        piece.place = glm::vec3(0);
        piece.radius = 0.8F;
        piece.cut = round % 2 == 0;
        choose_size(piece, c.random, turn);
        std::optional<glm::vec3> edges_before;
        for (const int use : {0, 1}) {
            std::optional<BoundBuffer> buffer;
            if ((turn + use) % 3 == 1) buffer.emplace();
            piece.turn = c.random.uniform(0, 6.28F);
            piece.size = c.random.uniform(1, 1.5F) * (use == 0 ? 0.6F : 1.2F);
            choose_colors(piece, c.random, (turn + 2 * use) % 4, edges_before);
            edges_before = piece.edges;
            choose_state(c.random);
            choose_watched(c.random);
            glLineWidth(static_cast<float>(10 + c.random.below(4)));
            stage.clear();
            choose_depths(c.random, static_cast<int>(c.random.below(4)));
            draw(out, piece);
            record_state(out, piece, stage.pixels(), any_edge(c.random, piece));
        }
    }
}

void random(Case& c, Recorder& out)
{
    std::vector<Piece> pieces;
    for (int i = 0; i < 14; ++i)
        pieces.push_back(
            random_piece(c.random, c.random.uniform(-0.05F, 0.05F) + 0.1F * static_cast<float>(i * 5 % 14 - 7)));
    choose_state(c.random);
    glEnable(GL_DEPTH_TEST);
    record_picture(out, 160, pieces);
}

}

const Driver driver = {
    {"sunflower",
     [](Case& c, Recorder& out) {
         const float turn = c.vary.near(0.0F, 3.0F);
         record_picture(out, 384, sunflower(110, turn, hue_shift(c.vary)));
     }},
    {"polygon",
     [](Case& c, Recorder& out) {
         record_written(c, out, 128, {{7, false, {0, 0, 0}, 0.9F, 0, {0.2F, 0.5F, 0.8F}, {1, 0.85F, 0.4F}}});
     }},
    {"triangles",
     [](Case& c, Recorder& out) {
         record_written(c, out, 128, {{11, true, {0, 0, 0}, 0.9F, 0, {0.2F, 0.6F, 0.5F}, {1, 0.85F, 0.4F}}});
     }},
    {"calls", calls},
    {"depth test", depth_test},
    {"buffer bound", buffer_bound},
    {"state", state},
    {"random", random},
};

}
