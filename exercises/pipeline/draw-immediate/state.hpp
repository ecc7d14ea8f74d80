#pragma once

#include <array>
#include <span>
#include <string>

#include "../seen.hpp"
#include "../support_gl.hpp"
#include "../watched_state.hpp"
#include "stage.hpp"

/// What the unit finds, and what it leaves.
namespace umbral::pipeline {

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

inline void choose_state(Random& random)
{
    constexpr GLenum modes[] = {GL_POINT, GL_LINE, GL_FILL};
    glPolygonMode(GL_FRONT, modes[random.below(3)]);
    glPolygonMode(GL_BACK, modes[random.below(3)]);
    random.below(2) == 0 ? glEnable(GL_DEPTH_TEST) : glDisable(GL_DEPTH_TEST);
    const float red = random.uniform();
    glColor4f(red, random.uniform(), red / 2, 0.25F + red / 2);
}

/// What lies in the depth buffer, by turns, while pieces lie at z = 0: nearer things, and the test off; things just
/// behind; things just in front, which hide all; nothing, and the test off. "Just" is 181 steps of 24 bits at least.
inline void choose_depths(Random& random, int turn)
{
    const double little = std::exp2(random.uniform(-16.5F, -11.0F));
    turn == 0 || turn == 3 ? glDisable(GL_DEPTH_TEST) : glEnable(GL_DEPTH_TEST);
    const std::array<double, 4> depths = {0.5 - little, 0.5 + little, 0.5 - little, 1};
    glClearDepth(depths[static_cast<std::size_t>(turn)]);
    glClear(GL_DEPTH_BUFFER_BIT);
    glClearDepth(1);
}

/// Sizes by turns: nothing, a few corners, and what 16 bits cannot count: positions, and indices or corners. 65,537
/// positions have one index more than that.
inline void choose_size(Piece& piece, Random& random, int turn)
{
    constexpr int all_of_16_bits = 65'536;
    piece.corners = turn == 0 ? 0 : 3 + static_cast<int>(random.below(6));
    piece.unused = 0;
    piece.idle = 0;
    if (turn == 2) piece.unused = all_of_16_bits - piece.corners;
    if (turn == 4) piece.unused = 70'000 + static_cast<int>(random.below(900));
    if (turn != 6) return;
    const int many = 500 + static_cast<int>(random.below(4000));
    if (piece.cut)
        piece.idle = all_of_16_bits / 3 + many;
    else
        piece.corners = all_of_16_bits + many;
}

// What is seen belongs to the row: who draws nothing leaves all state alone.
inline void record_state(Recorder& out, const Piece& piece, const Image& picture, int edge)
{
    std::array<GLfloat, 4> color{};
    glGetFloatv(GL_CURRENT_COLOR, color.data());
    std::array<GLint, 2> mode{};
    glGetIntegerv(GL_POLYGON_MODE, mode.data());
    std::vector<float> row = {
        color[0], color[1], color[2], color[3], static_cast<float>(mode[0]), static_cast<float>(mode[1])};
    for (const GLenum name : {GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING,
                              GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_DEPTH_TEST, GL_DEPTH_FUNC, GL_LINE_WIDTH})
        row.push_back(state_of(name));
    row.push_back(static_cast<float>(glGetError()));
    append_seen(row, picture, piece, edge);
    append_watched(row);
    const std::string names =
        "GL_CURRENT_COLOR/4, GL_POLYGON_MODE front, GL_POLYGON_MODE back, GL_ARRAY_BUFFER_BINDING, "
        "GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING, GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_DEPTH_TEST, "
        "GL_DEPTH_FUNC, GL_LINE_WIDTH, glGetError, " +
        std::string(seen_columns) + ", " + watched_columns();
    out.columns("state", names);
    out.append("state", std::span<const float>(row));
}

}
