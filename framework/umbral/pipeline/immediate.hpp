#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::pipeline {

// Drawing in immediate mode (modo inmediato): the tables stay in the application's memory, and travel at every call.
//
// What both functions find: OpenGL's fixed functionality (no program in use) with matrices set, vertex array object 0
// bound, no client array enabled, no index buffer bound. The depth function is GL_LESS, and the depth test off or on.
// Anything may be the current colour, the polygon mode (of front faces one, of back faces another), and the buffer
// bound to GL_ARRAY_BUFFER.
//
// What both do: one draw call fills, one draws the edges, each with all of the table in that one call. The edges show
// on their own fill whether the depth test is on or off, and are hidden by what is nearer. A table may be empty
// (then you may return at once), and may change from call to call.
//
// What both leave: all state as it was, and no object of OpenGL. (The place that glVertexPointer was told may stay: no
// array is enabled.) "Changes of state" below are all calls but those that draw, those that ask (glGet...), and those
// that set the current colour; putting back counts too, and so does each call of glPushAttrib, glPushClientAttrib
// and their glPop...

/// Draws a convex polygon of one colour, its edges in another: the course's tables for GL_LINE_LOOP, n corners,
/// anticlockwise.
///
/// Both colours are red, green, blue in [0, 1]. Needs at most 10 changes of state.
/// Course: problem 1.3, visualizarGL_MI_DAE.
void draw_polygon(const std::vector<glm::vec2>& corners, const glm::vec3& fill, const glm::vec3& edges);

/// Draws triangles of one colour, all of their edges in another: the course's tables of vertices and indices for
/// GL_TRIANGLES.
///
/// Indices come in threes, each less than the number of positions; triangles come in any order, and run either way.
/// Needs at most 11 changes of state. Course: problem 1.4.
void draw_triangles(const std::vector<glm::vec2>& positions, const std::vector<std::uint32_t>& indices,
                    const glm::vec3& fill, const glm::vec3& edges);

}
