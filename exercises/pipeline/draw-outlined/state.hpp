#pragma once

#include <span>

#include "../seen.hpp"
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

/// What is alive of the tables' objects.
inline void append_living(std::vector<float>& row)
{
    for (auto* const is_one : {glIsVertexArray, glIsBuffer}) row.push_back(static_cast<float>(living(is_one)));
}

/// A row for each use: what is bound once a drawing is made, and after the draw; what is seen, since who draws nothing
/// leaves all state alone; what is alive while the drawing lives (a drawing of nothing may have made objects or not),
/// and when it has gone.
struct Use {
    const Piece& piece;
    Bindings once_made;
    Image picture;
    int edge = 0;      ///< where to look
    bool made = true;  ///< whether the factory made a drawing
};

/// Says so if the factory made no drawing, before the row that shows it.
inline bool was_made(Recorder& out, const std::unique_ptr<OutlinedDrawing>& drawing)
{
    if (!drawing) out.refused("state", "the factory returned nullptr: every table has a drawing, also one of nothing");
    return drawing != nullptr;
}

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
    row.push_back(use.made ? 1 : 0);
    const std::string names =
        "GL_POLYGON_MODE front, GL_POLYGON_MODE back, attribute 0 enabled, attribute 1 enabled, "
        "GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, "
        "vertex array bound once made, array buffer bound once made, element buffer bound once made, "
        "GL_DEPTH_TEST, GL_DEPTH_FUNC, GL_LINE_WIDTH, " +
        std::string(seen_columns) +
        ", vertex arrays alive, buffers alive, vertex arrays alive when it has gone, buffers alive when it has gone, "
        "vertex array bound when it has gone, array buffer bound when it has gone, "
        "element buffer bound when it has gone, glGetError, " +
        watched_columns() + ", the drawing was made (0: nullptr; 1: yes)";
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

}
