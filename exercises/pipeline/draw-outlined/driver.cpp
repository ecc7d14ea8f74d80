#include <array>
#include <span>
#include <umbral/gl/record_trace.hpp>
#include <umbral/record/driver.hpp>

#include "../support_gl.hpp"
#include "../varied.hpp"
#include "shapes.hpp"

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

void sent_calls(Case& c, Recorder& out)
{
    const Stage stage(32);
    const Piece piece = large(c.vary, Piece::Way::sent, c.vary.one_of(9, std::array{6, 12, 15}));
    record_calls(out, "sent", [&] { draw(out, piece); });
}

// Made, drawn once, three times more in other colours, and gone.
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
    record_calls(out, "later frames", [&] {
        for (const float red : {0.3F, 0.6F, 0.9F}) frame(red);
    });
    record_calls(out, "end", [&] {
        ask_in_words(out, [] { return "drawing.reset();"; });
        drawing.reset();
    });
}

std::array<float, 3> bindings()
{
    return {state_of(GL_VERTEX_ARRAY_BINDING), state_of(GL_ARRAY_BUFFER_BINDING),
            state_of(GL_ELEMENT_ARRAY_BUFFER_BINDING)};
}

// What is seen belongs to the row: who draws nothing leaves all state alone. So do the bindings that making the drawing
// left. A drawing of nothing may have made objects or not.
void record_state(Recorder& out, const Image& picture, const std::array<float, 3>& once_made, bool has_objects)
{
    std::array<GLint, 2> mode{};
    glGetIntegerv(GL_POLYGON_MODE, mode.data());
    GLint enabled = 0;
    glGetVertexAttribiv(0, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
    const glm::u8vec4 seen = picture.at(picture.width / 2 + 2, picture.height / 2 + 3);
    const std::array<float, 3> now = bindings();
    const std::array row{static_cast<float>(mode[0]),
                         static_cast<float>(mode[1]),
                         static_cast<float>(enabled),
                         now[0],
                         now[1],
                         now[2],
                         once_made[0],
                         once_made[1],
                         once_made[2],
                         state_of(GL_DEPTH_TEST),
                         state_of(GL_DEPTH_FUNC),
                         state_of(GL_LINE_WIDTH),
                         has_objects ? living(glIsVertexArray) : 0,
                         has_objects ? living(glIsBuffer) : 0,
                         static_cast<float>(glGetError()),
                         static_cast<float>(seen.r),
                         static_cast<float>(seen.g),
                         static_cast<float>(seen.b)};
    out.columns("state",
                "GL_POLYGON_MODE front, GL_POLYGON_MODE back, attribute 0 enabled, GL_VERTEX_ARRAY_BINDING, "
                "GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, vertex array bound once made, "
                "array buffer bound once made, element buffer bound once made, GL_DEPTH_TEST, GL_DEPTH_FUNC, "
                "GL_LINE_WIDTH, vertex arrays alive, buffers alive, glGetError, pixel in the middle/3");
    out.append("state", std::span<const float>(row));
}

// The colour that others left as the current value of attribute 1.
void leave_black(Recorder& out)
{
    ask_in_words(out, [] { return "glVertexAttrib3f(1, 0, 0, 0);  // somebody else's"; });
    glVertexAttrib3f(1, 0, 0, 0);
}

// In every second round the fill has the colour of the edges before it, although others have drawn in between. What
// was made and never drawn leaves nothing behind.
void state(Case& c, Recorder& out)
{
    const Stage stage(32);
    glm::vec3 last_edges(0);
    for (int round = 0; round < 12; ++round) {
        Piece piece = random_piece(c.random);
        piece.way = static_cast<Piece::Way>(round % 3);
        piece.centre = glm::vec2(0);
        piece.radius = 0.8F;
        piece.corners = round < 3 ? 0 : piece.corners;
        glLineWidth(static_cast<float>(1 + c.random.below(6)));
        c.random.below(2) == 0 ? glEnable(GL_DEPTH_TEST) : glDisable(GL_DEPTH_TEST);
        if (round % 2 == 1) piece.fill = last_edges;
        last_edges = piece.edges;
        stage.clear();
        leave_black(out);
        if (piece.way != Piece::Way::sent) {
            auto unused = drawing_of(out, piece, "unused");
            ask_in_words(out, [] { return "unused.reset();  // never drawn"; });
            unused.reset();
        }
        std::unique_ptr<OutlinedDrawing> drawing;
        if (piece.way == Piece::Way::sent)
            draw(out, piece);
        else
            drawing = drawing_of(out, piece);
        const std::array<float, 3> once_made = bindings();
        if (drawing) ask<&OutlinedDrawing::draw>(out, *drawing, piece.fill, piece.edges);
        record_state(out, stage.picture(), once_made, piece.corners > 0);
    }
}

// Drawings that live at once, drawn in turn; the last ones when others have gone. The two polygons, of 300 corners
// each, come from one table that changes in its place; one of the wheels has 70,000 positions more than it needs.
void several(Case& c, Recorder& out)
{
    const Stage stage(160);
    const float hue = hue_shift(c.vary);
    std::vector<Piece> pieces;
    std::vector<std::unique_ptr<OutlinedDrawing>> drawings;
    std::vector<glm::vec2> table;
    for (int i = 0; i < 4; ++i) {
        const float side = i % 2 == 0 ? -0.45F : 0.45F;
        pieces.push_back({i < 2 ? Piece::Way::polygon : Piece::Way::triangles,
                          i < 2 ? 300 : 3 + 2 * i,
                          c.vary.near(glm::vec2(side, i < 2 ? 0.45F : -0.45F), 0.05F),
                          0.4F,
                          c.vary.near(0.0F, 0.5F),
                          rainbow(0.23F * static_cast<float>(i) + hue, 0.8F, 0.7F),
                          {1, 1, 1},
                          i == 3 ? 70'000 : 0});
        const std::string name = "drawing" + std::to_string(i);
        const std::vector<glm::vec2> corners = corners_of(pieces.back());
        if (i < 2) {
            table = corners;  // copied into the memory that it has
            drawings.push_back(ask_new<make_outlined_polygon>(out, name, table));
        } else {
            drawings.push_back(drawing_of(out, pieces.back(), name));
        }
    }
    const auto show = [&](std::size_t i) {
        if (drawings[i]) ask<&OutlinedDrawing::draw>(out, *drawings[i], pieces[i].fill, pieces[i].edges);
    };
    for (const std::size_t i : {3, 1, 0, 2}) show(i);
    drawings[0].reset();
    drawings[2].reset();
    std::swap(pieces[1].fill, pieces[3].fill);
    for (const std::size_t i : {1, 3}) show(i);
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
