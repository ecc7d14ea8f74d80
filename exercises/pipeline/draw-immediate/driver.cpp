#include <array>
#include <optional>
#include <span>
#include <umbral/gl/record_trace.hpp>
#include <umbral/record/driver.hpp>

#include "../support_gl.hpp"
#include "stage.hpp"

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

/// A buffer of another triangle, bound to GL_ARRAY_BUFFER while it lives.
class BoundBuffer {
public:
    BoundBuffer()
    {
        constexpr std::array<float, 64> other = {-0.9F, -0.9F, 0.9F, -0.9F, 0.2F, 0.9F};
        glGenBuffers(1, &name_);
        glBindBuffer(GL_ARRAY_BUFFER, name_);
        glBufferData(GL_ARRAY_BUFFER, sizeof other, other.data(), GL_STATIC_DRAW);
    }
    BoundBuffer(const BoundBuffer&) = delete;
    BoundBuffer& operator=(const BoundBuffer&) = delete;
    ~BoundBuffer() { glDeleteBuffers(1, &name_); }

private:
    GLuint name_ = 0;
};

void buffer_bound(Case& c, Recorder& out)
{
    const BoundBuffer buffer;
    record_written(c, out, 128,
                   {{6, false, {-0.45F, 0.1F, 0}, 0.45F, 0.2F, {0.2F, 0.6F, 0.5F}, {1, 1, 1}},
                    {9, true, {0.45F, -0.1F, 0}, 0.45F, 0, {0.7F, 0.5F, 0.1F}, {1, 1, 1}}});
}

void choose_state(Random& random)
{
    constexpr GLenum modes[] = {GL_POINT, GL_LINE, GL_FILL};
    glPolygonMode(GL_FRONT, modes[random.below(3)]);
    glPolygonMode(GL_BACK, modes[random.below(3)]);
    random.below(2) == 0 ? glEnable(GL_DEPTH_TEST) : glDisable(GL_DEPTH_TEST);
    const float red = random.uniform();
    glColor4f(red, random.uniform(), red / 2, 0.25F + red / 2);
}

void append_pixel(std::vector<float>& row, const Image& picture, glm::vec2 place)
{
    const glm::ivec2 pixel(0.5F * (place + 1.0F) * glm::vec2(picture.width, picture.height));
    const glm::u8vec4& found = picture.at(pixel.x, picture.height - 1 - pixel.y);
    row.insert(row.end(), {static_cast<float>(found.r), static_cast<float>(found.g), static_cast<float>(found.b)});
}

// What is seen belongs to the row: who draws nothing leaves all state alone.
void record_state(Recorder& out, const Piece& piece, const Image& picture)
{
    std::array<GLfloat, 4> color{};
    glGetFloatv(GL_CURRENT_COLOR, color.data());
    std::array<GLint, 2> mode{};
    glGetIntegerv(GL_POLYGON_MODE, mode.data());
    std::vector<float> row = {
        color[0], color[1], color[2], color[3], static_cast<float>(mode[0]), static_cast<float>(mode[1])};
    for (const GLenum name :
         {GL_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_VERTEX_ARRAY_BINDING, GL_CURRENT_PROGRAM,
          GL_DEPTH_TEST, GL_DEPTH_FUNC, GL_DEPTH_WRITEMASK, GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE,
          GL_LINE_WIDTH, GL_SHADE_MODEL, GL_MATRIX_MODE, GL_ATTRIB_STACK_DEPTH, GL_CLIENT_ATTRIB_STACK_DEPTH})
        row.push_back(state_of(name));
    row.push_back(static_cast<float>(glGetError()));
    // In the middle of the first triangle, and of the first edge.
    const float half = piece.corners > 0 ? std::numbers::pi_v<float> / static_cast<float>(piece.corners) : 0;
    const glm::vec2 towards(std::cos(half), std::sin(half));
    append_pixel(row, picture, 0.5F * piece.radius * std::cos(half) * towards);
    append_pixel(row, picture, piece.radius * std::cos(half) * towards);
    out.columns("state",
                "GL_CURRENT_COLOR/4, GL_POLYGON_MODE front, GL_POLYGON_MODE back, GL_ARRAY_BUFFER_BINDING, "
                "GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_VERTEX_ARRAY_BINDING, GL_CURRENT_PROGRAM, GL_DEPTH_TEST, "
                "GL_DEPTH_FUNC, GL_DEPTH_WRITEMASK, GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_LINE_WIDTH, "
                "GL_SHADE_MODEL, GL_MATRIX_MODE, GL_ATTRIB_STACK_DEPTH, GL_CLIENT_ATTRIB_STACK_DEPTH, glGetError, "
                "pixel in the first triangle/3, pixel in the first edge/3");
    out.append("state", std::span<const float>(row));
}

void state(Case& c, Recorder& out)
{
    const Stage stage(32);
    for (int round = 0; round < 12; ++round) {
        Piece piece = random_piece(c.random, 0.5F);
        piece.corners = round == 6 ? 0 : piece.corners;
        piece.place = glm::vec3(0);
        piece.radius = 0.8F;
        piece.turn = 0;
        piece.cut = round % 2 == 0;
        piece.unused = round % 4 == 2 ? 70'000 : 0;
        std::optional<BoundBuffer> buffer;
        if (round % 3 == 1) buffer.emplace();
        choose_state(c.random);
        stage.clear();
        draw(out, piece);
        record_state(out, piece, stage.pixels());
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
