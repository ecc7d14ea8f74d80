#include <array>
#include <span>
#include <umbral/gl/record_trace.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support_gl.hpp"
#include "../varied.hpp"
#include "../watched_state.hpp"
#include "meshes.hpp"

namespace umbral {
namespace {

using namespace pipeline;

/// Draws if there is something to draw with: a factory that gives nothing leaves the picture empty.
void draw(Recorder& out, const std::unique_ptr<IndexedDrawing>& drawing)
{
    if (drawing) ask<&IndexedDrawing::draw>(out, *drawing);
}

// The mesh is gone when the first draw comes.
std::unique_ptr<IndexedDrawing> drawing_of(Recorder& out, ColoredMesh mesh, std::string_view name = "drawing")
{
    return ask_new<make_indexed_drawing>(out, name, mesh);
}

/// A drawing of `mesh` as it is now: another of as many corners may be written over it later.
std::unique_ptr<IndexedDrawing> drawing_of_now(Recorder& out, const ColoredMesh& mesh, std::string_view name)
{
    return ask_new<make_indexed_drawing>(out, name, mesh);
}

// What comes next is what is left of a drawing that has gone.
void delete_drawing(Recorder& out, std::unique_ptr<IndexedDrawing>& drawing, std::string_view name = "drawing",
                    std::string_view before = "made before, and drawn")
{
    ask_in_words(out, [&] { return std::string(name) + ".reset();  // " + std::string(before); });
    drawing.reset();
}

void record_picture(Recorder& out, std::string_view name, const ColoredMesh& mesh, int size)
{
    const Canvas canvas(size);
    const auto drawing = drawing_of(out, mesh);
    draw(out, drawing);
    out.image(name, canvas.picture());
}

template <class Work>
void record_calls(Recorder& out, std::string_view name, Work&& work)
{
    gl::begin_trace();
    work();
    gl::record_trace(out, name, gl::end_trace());
}

/// Says so if the factory made no drawing, before the row of `table` that shows it.
bool was_made(Recorder& out, std::string_view table, const std::unique_ptr<IndexedDrawing>& drawing)
{
    if (!drawing)
        out.refused(table, "make_indexed_drawing returned nullptr: every mesh has a drawing, also one of no triangles");
    return drawing != nullptr;
}

void count_alive(Recorder& out, bool made)
{
    out.columns("alive", "vertex array objects alive, buffers alive, the drawing was made (0: nullptr; 1: yes)");
    out.append("alive", glm::vec3(living(glIsVertexArray), living(glIsBuffer), made ? 1 : 0));
}

// Another drawing is drawn between the frames: who keeps only what was drawn last sends it again each time.
//
// What is alive is counted beside the trace: deleting the name 0 deletes nothing. What was never drawn goes as well,
// and what is empty.
void frames(Case& c, Recorder& out)
{
    const int petals = c.vary.one_of(8, std::array{6, 7, 9});
    const float hue = hue_shift(c.vary);
    const Canvas canvas(256);
    const auto other = drawing_of(out, polygon(5, {0.84F, 0.84F, -0.2F}, 0.13F, hue), "other");
    draw(out, other);
    std::unique_ptr<IndexedDrawing> drawing;
    record_calls(out, "first frame", [&] {
        drawing = drawing_of(out, rosette(petals, 12, hue));
        draw(out, drawing);
    });
    record_calls(out, "later frames", [&] {
        for (int frame = 0; frame < 3; ++frame) {
            draw(out, other);
            draw(out, drawing);
        }
    });
    out.image("fourth frame", canvas.picture());
    count_alive(out, was_made(out, "alive", drawing));
    auto unused = drawing_of(out, polygon(5, {0, 0, 0}, 0.8F, 0), "unused");
    const bool unused_made = was_made(out, "alive", unused);
    delete_drawing(out, unused, "unused", "made before, and never drawn");
    count_alive(out, unused_made);
    const bool drawing_made = was_made(out, "alive", drawing);
    record_calls(out, "end", [&] { delete_drawing(out, drawing); });
    count_alive(out, drawing_made);
    auto empty = drawing_of(out, {}, "empty");
    const bool empty_made = was_made(out, "alive", empty);
    draw(out, empty);
    delete_drawing(out, empty, "empty", "made before of no triangles, and drawn");
    count_alive(out, empty_made);
}

/// State that has nothing to do with where vertices come from, and for which the software renderer need not compile its
/// shaders anew. The current values are those that vertices have where no array feeds them.
void choose_state(Random& random)
{
    choose_watched(random);
    random.below(2) == 0 ? glEnable(GL_SCISSOR_TEST) : glDisable(GL_SCISSOR_TEST);
    glLineWidth(static_cast<float>(1 + random.below(6)));
    glDepthFunc(random.below(2) == 0 ? GL_LESS : GL_ALWAYS);
    const float red = random.uniform();
    glVertexAttrib4f(1, red, random.uniform(), 1 - red, red / 2);
    glColor4f(random.uniform(), 1 - red, red / 2, 0.5F);
}

void record_state(Recorder& out, bool made)
{
    const auto enabled = [](GLuint location) {
        GLint value = 0;
        glGetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &value);
        return static_cast<float>(value);
    };
    std::array<GLint, 2> mode{};
    glGetIntegerv(GL_POLYGON_MODE, mode.data());
    std::vector<float> row = {state_of(GL_VERTEX_ARRAY_BINDING),
                              state_of(GL_ARRAY_BUFFER_BINDING),
                              state_of(GL_ELEMENT_ARRAY_BUFFER_BINDING),
                              enabled(0),
                              enabled(1),
                              state_of(GL_DEPTH_TEST),
                              state_of(GL_DEPTH_FUNC),
                              state_of(GL_LINE_WIDTH),
                              static_cast<float>(mode[0]),
                              static_cast<float>(mode[1]),
                              static_cast<float>(glGetError())};
    std::array<GLfloat, 4> current{};
    glGetVertexAttribfv(1, GL_CURRENT_VERTEX_ATTRIB, current.data());
    row.insert(row.end(), current.begin(), current.end());
    glGetFloatv(GL_CURRENT_COLOR, current.data());
    row.insert(row.end(), current.begin(), current.end());
    append_watched(row);
    row.push_back(made ? 1 : 0);
    const std::string names =
        "GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, "
        "attribute 0 enabled, attribute 1 enabled, GL_DEPTH_TEST, GL_DEPTH_FUNC, GL_LINE_WIDTH, "
        "GL_POLYGON_MODE front, GL_POLYGON_MODE back, glGetError, current value of attribute 1/4, "
        "GL_CURRENT_COLOR/4, " +
        watched_columns() + ", the drawing was made (0: nullptr; 1: yes)";
    out.columns("state", names);
    out.append("state", std::span<const float>(row));
}

// Every third mesh is empty.
void state(Case& c, Recorder& out)
{
    const Canvas canvas(64);
    for (int round = 0; round < 9; ++round) {
        choose_state(c.random);
        const ColoredMesh mesh =
            round % 3 == 2 ? ColoredMesh{} : polygon(5 + round, {0, 0, 0}, 0.8F, c.random.uniform());
        auto drawing = drawing_of(out, mesh);
        const bool made = was_made(out, "state", drawing);
        record_state(out, made);
        for (int frame = 0; frame < 3; ++frame) {
            choose_state(c.random);
            draw(out, drawing);
            record_state(out, made);
        }
        delete_drawing(out, drawing);
        record_state(out, made);
    }
}

// Drawings that live at once, one of them empty, two of them of one mesh that has changed in its place; the last one is
// drawn when others have gone.
void several(Case& c, Recorder& out)
{
    const Canvas canvas(256);
    const float hue = hue_shift(c.vary);
    const auto placed = [&](int corners, const glm::vec3& centre, float radius, float its_hue) {
        return polygon(corners, c.vary.near(centre, 0.04F), radius, its_hue + hue);
    };
    const ColoredMesh before = placed(6, {0.05F, -0.1F, 0}, 0.6F, 0.55F);
    const ColoredMesh after = placed(6, {0.5F, 0.45F, 0.2F}, 0.4F, 0.3F);
    ColoredMesh changing = before;
    std::array drawings{drawing_of(out, placed(3, {-0.45F, 0.4F, 0.3F}, 0.5F, 0.0F), "drawing0"),
                        drawing_of(out, {}, "drawing1"), drawing_of_now(out, changing, "drawing2"),
                        drawing_of_now(out, changing = after, "drawing3"),
                        drawing_of(out, placed(5, {0.4F, -0.5F, -0.1F}, 0.42F, 0.8F), "drawing4")};
    for (const std::size_t i : {3, 1, 0, 2, 1, 3}) draw(out, drawings[i]);
    out.image("first", canvas.picture());
    for (const std::size_t i : {0, 2, 1}) drawings[i].reset();
    canvas.clear();
    draw(out, drawings[4]);
    draw(out, drawings[3]);
    out.image("after some have gone", canvas.picture());
}

void random(Case& c, Recorder& out)
{
    for (int i = 0; i < 3; ++i)
        record_picture(out, "picture " + std::to_string(i + 1), random_mesh(c.random, 30, 25), 128);
}

}

const Driver driver = {
    {"rosette",
     [](Case& c, Recorder& out) {
         const int petals = c.vary.one_of(12, std::array{9, 10, 11});
         record_picture(out, "picture", rosette(petals, 16, hue_shift(c.vary)), 384);
     }},
    {"frames", frames},
    {"state", state},
    {"several", several},
    {"many vertices",
     [](Case& c, Recorder& out) {
         record_picture(out, "picture", sheet(257, 257, 8, hue_shift(c.vary)), 192);
         record_picture(out, "65537", sheet_and_one(hue_shift(c.vary)), 192);
     }},
    {"random", random},
};

}
