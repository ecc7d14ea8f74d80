#include <array>
#include <optional>
#include <umbral/gl/record_trace.hpp>
#include <umbral/record/driver.hpp>

#include "../support_gl.hpp"
#include "../varied.hpp"
#include "shapes.hpp"
#include "state.hpp"

namespace umbral {
namespace {

using namespace pipeline;

/// The picture and the state that the unit finds.
class Stage {
public:
    explicit Stage(int size) : canvas_(size)
    {
        glDepthFunc(GL_LEQUAL);
        glLineWidth(5);
    }
    void clear() const { canvas_.clear(); }
    [[nodiscard]] Image picture() const { return canvas_.picture(); }

private:
    Canvas canvas_;
};

void record_picture(Recorder& out, int size, const std::vector<Piece>& pieces)
{
    const Stage stage(size);
    for (const Piece& piece : pieces) draw(out, piece);
    out.image("picture", stage.picture());
}

Piece large(Variation& vary, Piece::Way way, int corners)
{
    Piece piece{way, vary.near(corners, 1), {0, 0}, 0.9F, vary.near(0.2F, 0.5F)};
    piece.fill = other_color(vary, {0.2F, 0.5F, 0.8F});
    piece.edges = other_color(vary, {1, 0.85F, 0.4F});
    return piece;
}

void record_large(Case& c, Recorder& out, Piece::Way way, int corners)
{
    record_picture(out, 128, {large(c.vary, way, corners)});
}

template <class Work>
void record_calls(Recorder& out, std::string_view name, Work&& work)
{
    gl::begin_trace();
    work();
    gl::record_trace(out, name, gl::end_trace());
}

// One of the corners comes twice: it is sent twice.
void sent_calls(Case& c, Recorder& out)
{
    const Stage stage(32);
    const Piece piece = large(c.vary, Piece::Way::sent, c.vary.one_of(9, std::array{6, 12, 15}));
    std::vector<glm::vec2> corners = corners_of(piece);
    const auto twice = corners.begin() + c.vary.near(3, 2);
    corners.insert(twice, *twice);
    record_calls(out, "sent", [&] { ask<send_polygon>(out, corners, piece.fill, piece.edges); });
}

void count_alive(Recorder& out)
{
    out.columns("alive", "vertex arrays alive, buffers alive");
    out.append("alive", glm::vec2(living(glIsVertexArray), living(glIsBuffer)));
}

// Made, drawn once, three times more in other colours, and gone. What lives then is counted, not what is deleted:
// deleting the name 0 is allowed, and deletes nothing.
void frames(Case& c, Recorder& out, Piece::Way way)
{
    const Stage stage(64);
    const Piece piece = large(c.vary, way, c.vary.one_of(11, std::array{8, 14, 17}));
    std::unique_ptr<OutlinedDrawing> drawing;
    const auto frame = [&](float red) {
        if (drawing) ask<&OutlinedDrawing::draw>(out, *drawing, {red, 0.4F, 0.3F}, {1, 1, red});
    };
    record_calls(out, "first frame", [&] {
        drawing = drawing_of(out, piece);
        frame(0.1F);
    });
    count_alive(out);
    record_calls(out, "later frames", [&] {
        for (const float red : {0.3F, 0.6F, 0.9F}) frame(red);
    });
    count_alive(out);
    ask_in_words(out, [] { return "drawing.reset();"; });
    drawing.reset();
    count_alive(out);
}

// One use: all is cleared, and others have set attribute 1, before the draw.
void use(Recorder& out, Case& c, const Stage& stage, const Piece& piece, std::unique_ptr<OutlinedDrawing>& drawing,
         const Bindings& once_made, bool goes)
{
    const bool made = piece.way == Piece::Way::sent || was_made(out, drawing);
    stage.clear();
    leave_other_color(out, c.random);
    if (piece.way == Piece::Way::sent)
        draw(out, piece);
    else if (drawing)
        ask<&OutlinedDrawing::draw>(out, *drawing, piece.fill, piece.edges);
    record_state(out, {piece, once_made, stage.picture(), any_edge(c.random, piece), made}, drawing, goes);
}

// Each of the three ways in eight rounds, twice in each. What was made and never drawn leaves nothing behind.
void state(Case& c, Recorder& out)
{
    const Stage stage(64);
    for (int round = 0; round < 24; ++round) {
        const int turn = round / 3;
        Piece piece = random_piece(c.random);
        piece.way = static_cast<Piece::Way>(round % 3);
        piece.centre = glm::vec2(0);
        piece.radius = 0.8F;
        piece.corners = 3 + static_cast<int>(c.random.below(6));
        choose_size(piece, c.random, turn);
        choose_colors(piece, c.random, turn % 4, std::nullopt);
        glLineWidth(static_cast<float>(10 + c.random.below(4)));
        c.random.below(2) == 0 ? glEnable(GL_DEPTH_TEST) : glDisable(GL_DEPTH_TEST);
        choose_watched(c.random);
        std::unique_ptr<OutlinedDrawing> drawing;
        if (piece.way != Piece::Way::sent) {
            auto unused = drawing_of(out, piece, "unused");
            ask_in_words(out, [] { return "unused.reset();  // never drawn"; });
            unused.reset();
            drawing = drawing_of(out, piece);
        }
        const Bindings once_made;
        use(out, c, stage, piece, drawing, once_made, false);
        choose_colors(piece, c.random, (turn + 2) % 4, piece.edges);
        use(out, c, stage, piece, drawing, once_made, true);
    }
}

// Two polygons, then two wheels, that come in turn from one table that changes in its place; a polygon whose corners
// 16 bits cannot count, and a wheel whose last position and whose last triangles have no number of 16 bits.
std::vector<Piece> several_pieces(Variation& vary)
{
    constexpr std::array corners = {300, 300, 9, 9, 70'000, 7};
    const float hue = hue_shift(vary);
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto k = static_cast<float>(i);
        const glm::vec2 place(0.62F * static_cast<float>(i / 2) - 0.62F, i % 2 == 0 ? -0.45F : 0.45F);
        pieces.push_back({i / 2 == 1 || i == 5 ? Piece::Way::triangles : Piece::Way::polygon, corners[i],
                          vary.near(place, 0.03F), 0.27F, vary.near(0.3F * k, 0.5F),
                          rainbow(0.17F * k + hue, 0.8F, 0.7F), glm::vec3(1)});
    }
    pieces[4].corners += vary.near(0, 2000);
    pieces[5].unused = 65'536 - pieces[5].corners;
    pieces[5].idle = 22'000 + vary.near(0, 100);
    return pieces;
}

// Drawings that live at once, drawn in turn; the last ones when others have gone.
void several(Case& c, Recorder& out)
{
    const Stage stage(160);
    std::vector<Piece> pieces = several_pieces(c.vary);
    std::vector<std::unique_ptr<OutlinedDrawing>> drawings;
    std::vector<glm::vec2> table;
    Wheel wheel;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::string name = "drawing" + std::to_string(i);
        if (pieces[i].way == Piece::Way::polygon) {
            const std::vector<glm::vec2> corners = corners_of(pieces[i]);
            table = corners;  // copied into the memory that it has
            drawings.push_back(ask_new<make_outlined_polygon>(out, name, table));
        } else {
            const Wheel next = wheel_of(pieces[i]);
            wheel = next;
            drawings.push_back(ask_new<make_outlined_triangles>(out, name, wheel.positions, wheel.indices));
        }
    }
    const auto show = [&](std::size_t i) {
        if (drawings[i]) ask<&OutlinedDrawing::draw>(out, *drawings[i], pieces[i].fill, pieces[i].edges);
    };
    for (const std::size_t i : {3, 5, 1, 0, 4, 2}) show(i);
    drawings[0].reset();
    drawings[2].reset();
    std::swap(pieces[1].fill, pieces[3].fill);
    for (const std::size_t i : {1, 3, 4}) show(i);
    out.image("picture", stage.picture());
}

void random(Case& c, Recorder& out)
{
    std::vector<Piece> pieces;
    for (int i = 0; i < 12; ++i) pieces.push_back(random_piece(c.random));
    record_picture(out, 160, pieces);
}

}

const Driver driver = {
    {"window",
     [](Case& c, Recorder& out) {
         const float turn = c.vary.near(0.0F, 3.0F);
         record_picture(out, 384, window(turn, hue_shift(c.vary)));
     }},
    {"sent", [](Case& c, Recorder& out) { record_large(c, out, Piece::Way::sent, 7); }},
    {"polygon", [](Case& c, Recorder& out) { record_large(c, out, Piece::Way::polygon, 5); }},
    {"triangles", [](Case& c, Recorder& out) { record_large(c, out, Piece::Way::triangles, 8); }},
    {"calls", sent_calls},
    {"polygon frames", [](Case& c, Recorder& out) { frames(c, out, Piece::Way::polygon); }},
    {"triangle frames", [](Case& c, Recorder& out) { frames(c, out, Piece::Way::triangles); }},
    {"state", state},
    {"several", several},
    {"random", random},
};

}
