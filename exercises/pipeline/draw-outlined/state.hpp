#pragma once

#include <optional>
#include <span>

#include "../support_gl.hpp"
#include "../watched_state.hpp"
#include "shapes.hpp"

/// What the unit leaves behind: state, objects, and what is seen.
namespace umbral::pipeline {

struct Bindings {
    float vertex_array = state_of(GL_VERTEX_ARRAY_BINDING);
    float array_buffer = state_of(GL_ARRAY_BUFFER_BINDING);
    float element_buffer = state_of(GL_ELEMENT_ARRAY_BUFFER_BINDING);
};

inline void append(std::vector<float>& row, const Bindings& bindings)
{
    row.insert(row.end(), {bindings.vertex_array, bindings.array_buffer, bindings.element_buffer});
}

inline float attribute_enabled(GLuint attribute)
{
    GLint enabled = 0;
    glGetVertexAttribiv(attribute, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
    return static_cast<float>(enabled);
}

/// The pixel at a place in clip coordinates.
inline void append_pixel(std::vector<float>& row, const Image& picture, glm::vec2 place)
{
    const glm::ivec2 pixel(0.5F * (place + 1.0F) * glm::vec2(picture.width, picture.height));
    const glm::u8vec4& found = picture.at(pixel.x, picture.height - 1 - pixel.y);
    row.insert(row.end(), {static_cast<float>(found.r), static_cast<float>(found.g), static_cast<float>(found.b)});
}

/// A piece round the origin, at two of its edges: in the middle of the fill there, on the outer half of the edge, and
/// half way to the corner, where wheels have an edge too. Lines are so wide that these pixels have one colour each.
inline void append_seen(std::vector<float>& row, const Image& picture, const Piece& piece, int edge)
{
    const int corners = std::max(piece.corners, 3);
    const float half = std::numbers::pi_v<float> / static_cast<float>(corners);
    const float reach = piece.radius * std::cos(half);
    const auto at = [&](float radius, float angle) {
        append_pixel(row, picture, radius * glm::vec2(std::cos(angle), std::sin(angle)));
    };
    for (const int k : {edge, edge + corners / 2}) {
        const float corner = piece.turn + 2 * half * static_cast<float>(k);
        at(0.6F * reach, corner + half);
        at(reach + 0.03F, corner + half);
        at(0.5F * piece.radius, corner);
    }
}

/// What is alive of the tables' objects.
inline void append_living(std::vector<float>& row)
{
    row.insert(row.end(), {living(glIsVertexArray), living(glIsBuffer)});
}

/// A row for each use: what is bound once a drawing is made, and after the draw; what is seen, since who draws nothing
/// leaves all state alone; what is alive while the drawing lives (a drawing of nothing may have made objects or not),
/// and when it has gone.
struct Use {
    const Piece& piece;
    Bindings once_made;
    Image picture;
    int edge = 0;  ///< where to look
};

inline void record_state(Recorder& out, const Use& use, std::unique_ptr<OutlinedDrawing>& drawing, bool goes)
{
    std::array<GLint, 2> mode{};
    glGetIntegerv(GL_POLYGON_MODE, mode.data());
    std::vector<float> row = {static_cast<float>(mode[0]), static_cast<float>(mode[1]), attribute_enabled(0),
                              attribute_enabled(1)};
    append(row, Bindings());
    append(row, use.once_made);
    row.insert(row.end(), {state_of(GL_DEPTH_TEST), state_of(GL_DEPTH_FUNC), state_of(GL_LINE_WIDTH)});
    append_seen(row, use.picture, use.piece, use.edge);
    if (use.piece.corners > 0)
        append_living(row);
    else
        row.insert(row.end(), {0, 0});
    if (goes && drawing) {
        ask_in_words(out, [] { return "drawing.reset();  // drawn twice before"; });
        drawing.reset();
    }
    if (!drawing)
        append_living(row);
    else
        row.insert(row.end(), {0, 0});
    append(row, Bindings());
    row.push_back(static_cast<float>(glGetError()));
    append_watched(row);
    const std::string names =
        "GL_POLYGON_MODE front, GL_POLYGON_MODE back, attribute 0 enabled, attribute 1 enabled, "
        "GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, "
        "vertex array bound once made, array buffer bound once made, element buffer bound once made, "
        "GL_DEPTH_TEST, GL_DEPTH_FUNC, GL_LINE_WIDTH, "
        "pixel of the fill/3, pixel on an edge/3, pixel towards a corner/3, "
        "pixel of the fill elsewhere/3, pixel on another edge/3, pixel towards another corner/3, "
        "vertex arrays alive, buffers alive, vertex arrays alive when it has gone, buffers alive when it has gone, "
        "vertex array bound when it has gone, array buffer bound when it has gone, "
        "element buffer bound when it has gone, glGetError, " +
        watched_columns();
    out.columns("state", names);
    out.append("state", std::span<const float>(row));
}

/// What others leave as the current value of attribute 1.
inline void leave_other_color(Recorder& out, Random& random)
{
    const glm::vec3 color = rainbow(random.uniform(), 0.7F, 0.9F);
    ask_in_words(out, [&] {
        return "glVertexAttrib4f(1, " + std::to_string(color.r) + ", " + std::to_string(color.g) + ", " +
               std::to_string(color.b) + ", 0);  // somebody else's";
    });
    glVertexAttrib4f(1, color.r, color.g, color.b, 0);
}

/// Sizes by turns: nothing, a few corners, and what 16 bits cannot count: corners, indices, positions. 65,537 positions
/// have one index more than that.
inline void choose_size(Piece& piece, Random& random, int turn)
{
    constexpr int all_of_16_bits = 65'536;
    piece.unused = 0;
    if (turn == 0) piece.corners = 0;
    if (turn == 2) piece.unused = all_of_16_bits - piece.corners;
    if (turn == 4) piece.unused = 70'000 + static_cast<int>(random.below(900));
    if (turn != 6) return;
    const int many = 500 + static_cast<int>(random.below(4000));
    if (piece.way == Piece::Way::triangles)
        piece.idle = all_of_16_bits / 3 + many;
    else
        piece.corners = all_of_16_bits + many;
}

/// Colours by turns: any; a fill of black; fill and edges alike; edges of black. In the second draw fills have the
/// colour of the edges before, although others have drawn in between.
inline void choose_colors(Piece& piece, Random& random, int turn, const std::optional<glm::vec3>& edges_before)
{
    piece.fill = edges_before.value_or(rainbow(random.uniform(), 0.8F, 0.8F));
    piece.edges = rainbow(random.uniform(), 0.25F, 1);
    if (turn == 1) piece.fill = glm::vec3(0);
    if (turn == 2) piece.edges = piece.fill;
    if (turn == 3) piece.edges = glm::vec3(0);
}

}
