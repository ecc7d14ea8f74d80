#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::pipeline {

/// Triangles with a colour at each vertex: the course's tables of coordinates, colours and indices (estructura de
/// arrays).
///
/// As many colours as positions; indices come in threes, each less than the number of positions. All three tables may
/// be empty, a vertex may be used by no triangle, and there may be more vertices than 16 bits can number.
struct ColoredMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> colors;  ///< red, green, blue in [0, 1]
    std::vector<std::uint32_t> indices;
};

/// A mesh kept in the memory of the graphics card (modo diferido): one vertex array object and three buffers, of
/// positions, colours, indices.
///
/// All of it is made once, by the factory or by the first draw, and deleted with this object. Needs a current OpenGL
/// context all its life.
class IndexedDrawing {
public:
    virtual ~IndexedDrawing() = default;

    /// Draws the triangles with the program in use, whose attribute 0 is the position and whose attribute 1 is the
    /// colour (both vec3).
    ///
    /// From the second time on it uploads nothing, and needs three calls: one of them draws. It finds no vertex array
    /// and no buffer bound, and leaves it so; everything else (program, depth test, ...) stays as it is.
    virtual void draw() = 0;
};

/// A drawing of `mesh`, which may change or go away afterwards. Drawings share nothing, so that several may live at
/// once. Course: problems 1.5 and 1.6, DescrTabla, ArrayVertices::visualizarGL_MD_VAO.
[[nodiscard]] std::unique_ptr<IndexedDrawing> make_indexed_drawing(const ColoredMesh& mesh);

}
