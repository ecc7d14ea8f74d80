#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::pipeline {

// Shapes of one colour with their edges in another: vertex by vertex, and from the memory of the graphics card.
//
// What all of this finds: a program in use whose attribute 0 is the position and whose attribute 1 is the colour, its
// current value anything; no vertex array and no buffer bound; the polygon mode GL_FILL, and the depth function
// GL_LEQUAL, so that edges show on their own fill. What it leaves: all state as it was, but for the current value of
// attribute 1, which is what glVertexAttrib3f(1, ...) sets: all vertices get it while no array feeds the attribute.
// Colours are red, green, blue in [0, 1]; places are in clip coordinates, with z = 0.

/// Sends a convex polygon, anticlockwise, vertex by vertex, a glVertex for each: one pair of glBegin and glEnd fills
/// it, another draws its edges.
///
/// No object of OpenGL, no array and no draw call from tables. No corners at all draw nothing. Course: "glBegin,
/// glVertex, glEnd", visualizarGL_MI_BVE.
void send_polygon(const std::vector<glm::vec2>& corners, const glm::vec3& fill, const glm::vec3& edges);

/// A shape that is kept in the memory of the graphics card.
///
/// Everything is made once, by its factory or by the first draw, and deleted with the object. Needs a current OpenGL
/// context all its life. Drawings share nothing.
class OutlinedDrawing {
public:
    virtual ~OutlinedDrawing() = default;

    /// Draws the inside in one colour, then the edges in the other: two draw calls that read the same buffers. From the
    /// second time on it uploads nothing.
    virtual void draw(const glm::vec3& fill, const glm::vec3& edges) = 0;
};

/// The polygon of `send_polygon`, in one vertex array object and one buffer of corners: both passes are glDrawArrays.
///
/// A draw changes state twice at most: the vertex array is bound and unbound. `corners` may change or go afterwards.
/// Course: problem 1.5.
[[nodiscard]] std::unique_ptr<OutlinedDrawing> make_outlined_polygon(const std::vector<glm::vec2>& corners);

/// Triangles, all of whose edges show, in one vertex array object and two buffers, of positions and of indices: both
/// passes are the same glDrawElements.
///
/// Indices come in threes, each less than the number of positions; triangles run either way. A draw changes state four
/// times at most: beside the binding, the polygon mode becomes GL_LINE and GL_FILL again. The tables may change or go
/// afterwards. Course: problem 1.6.
[[nodiscard]] std::unique_ptr<OutlinedDrawing> make_outlined_triangles(const std::vector<glm::vec2>& positions,
                                                                       const std::vector<std::uint32_t>& indices);

}
